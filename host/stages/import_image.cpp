#include "host/stages/import_image.hpp"

#include <iterator>

#include "host/core/depth.hpp"
#include "host/core/imported_images.hpp"

namespace quell {
namespace {

int depthOption(DepthKind kind) {
  if (isDepthBuffer(kind)) return QUELL_DEPTH_RECIPROCAL;
  if (kind == DepthKind::Ray) return QUELL_DEPTH_ALONG_RAY;
  return kind == DepthKind::NegativeView ? QUELL_DEPTH_NEGATED : QUELL_DEPTH_AS_IT_IS;
}

}  // namespace

std::vector<Port> ImportImage::ports(const Configuration& configuration, const Content&) const {
  Port source;
  source.name = m_image.name;
  source.input = m_image.member;
  source.options = "SOURCE";
  source.asGiven = true;
  Port imported;
  imported.name = m_buffer.c_str();
  imported.access = Access::Write;
  imported.extent = importedExtent(configuration.frame, m_image.member);
  return {source, imported};
}

void ImportImage::build(const KernelBuilder& builder) {
  const Frame& frame = builder.configuration().frame;
  const ImageView& view = frame.*m_image.member;
  const int depth = m_image.member == &Frame::viewDepth ? depthOption(frame.depthKind) : QUELL_DEPTH_AS_IT_IS;
  m_kernel = builder.build(
      *this, " -D SUM=" + std::to_string(static_cast<int>(view.sum)) + " -D DEPTH=" + std::to_string(depth) +
                 " -D IDENTIFIERS=" + (m_image.identifiers() ? "1" : "0") +
                 " -D CHANNELS=" + std::to_string(viewForStages(frame, m_image.member).channels));
  m_workGroup = builder.pixelWorkGroup(m_kernel);
}

ImportImageParams ImportImage::params(const FrameRun& run) const {
  const Frame& frame = run.frame;
  ImportImageParams params{};
  params.width = frame.size.width;
  params.height = frame.size.height;
  params.source = makeViewParams(frame.*m_image.member, frame.size);
  params.sampleCount = static_cast<float>(frame.sampleCount);
  if (m_image.member != &Frame::viewDepth) return params;
  if (frame.depthKind == DepthKind::Ray) {
    params.rayX = run.reprojection.rayX;
    params.rayY = run.reprojection.rayY;
    params.rayOrigin = run.reprojection.rayOrigin;
  } else if (isDepthBuffer(frame.depthKind)) {
    const ReciprocalDepth depth = reciprocalDepth(frame.depthKind, frame.depthNear, frame.depthFar);
    params.depthConstant = static_cast<float>(depth.constant);
    params.depthSlope = static_cast<float>(depth.slope);
  }
  return params;
}

void ImportImage::enqueue(FrameRun& run) { run.launch(m_kernel, run.pixelRange(), m_workGroup, params(run)); }

void addImports(Schedule& table, const Configuration& configuration) {
  Schedule imports;
  for (const auto& image : kInputs<Frame>)
    if (isImported(configuration.frame, image.member) && readsImage(table, configuration, image.member))
      imports.push_back({std::make_unique<ImportImage>(image), {}});
  table.insert(table.begin(), std::make_move_iterator(imports.begin()),
               std::make_move_iterator(imports.end()));
}

}  // namespace quell

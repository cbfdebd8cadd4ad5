#include "host/stages/tone_map.hpp"

namespace quell {

void ToneMap::build(const KernelBuilder& builder) {
  const ImageView output = m_isLast ? builder.configuration().output.display : ImageView();
  m_kernel = builder.build("tone_map", layoutOptions("OUTPUT", output) +
                                           " -D WRITE_PLANES=" + (m_isLast ? "0" : "1") + skipOption(m_skip));
  m_workGroup = builder.pixelWorkGroup(m_kernel);
}

void ToneMap::enqueue(FrameRun& run) {
  const ImageView output = m_isLast ? run.output.display : ImageView();
  ToneMapParams params{};
  params.planes = makePlanes(run.configuration.size());
  params.output = makeViewParams(output, run.configuration.size());
  run.launch(m_kernel, run.pixelRange(), m_workGroup, run.buffer("linear"),
             m_isLast ? cl::Buffer() : run.buffer("encoded"), output,
             m_skip ? run.buffer("surfaces") : cl::Buffer(), params);
}

std::uint64_t ToneMap::callerBytes(const Configuration& configuration) const {
  return m_isLast ? imageBytes(configuration.output.display, configuration.size()) : 0;
}

}  // namespace quell

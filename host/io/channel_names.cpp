#include "host/io/channel_names.hpp"

#include <algorithm>
#include <quell/error.hpp>
#include <sstream>

#include "host/io/frame_sequence.hpp"

namespace quell::io {
namespace {

struct TableRow {
  const char* renderer;
  const char* image;
  const char* sources;
};

// Where several renderers fit equally well, the first is taken. Files show what stands beside the frames as
// docs/frames-from-my-renderer.md says.
constexpr TableRow kTable[] = {
    // Blender 3.4 to 4.x abbreviates passes, Blender 5 writes them out. "Noisy Image" is there where Blender itself
    // denoises Combined; "Image" is what a File Output node calls it.
    {"cycles", "color", "Noisy Image|Combined|Image"},
    {"cycles", "normal", "Normal"},
    {"cycles", "position", "Position"},
    {"cycles", "depth", "Depth"},
    {"cycles", "albedo", "DiffCol|Diffuse Color"},
    {"cycles", "gloss_color", "GlossCol|Glossy Color"},
    {"cycles", "transmission_color", "TransCol|Transmission Color"},
    {"cycles", "roughness", "roughness|Roughness"},
    {"cycles", "emission", "Emit+Env|Emission+Environment|Emit|Env|Emission|Environment"},
    {"cycles", "motion", "Vector:y-up"},
    {"cycles", "object_id", "IndexOB|Object Index"},
    {"cycles", "diffuse", "DiffDir+DiffInd|Diffuse Direct+Diffuse Indirect"},
    {"cycles", "glossy", "GlossDir+GlossInd|Glossy Direct+Glossy Indirect"},
    // Names are the scene's; these are what its documentation and this project use. Its depth is a distance.
    {"mitsuba", "color", "R,G,B"},
    {"mitsuba", "normal", "sh_normal|nn|n|normals|normal"},
    {"mitsuba", "position", "position|pos|p"},
    {"mitsuba", "depth", "depth:ray|dd.y:ray|dd:ray|d:ray"},
    {"mitsuba", "albedo", "albedo|alb"},
    {"mitsuba", "object_id", "shape_index|id"},
    // A file per output, which is named after it.
    {"luxcore", "color", "RGB|RGBA"},
    {"luxcore", "alpha", "ALPHA"},
    {"luxcore", "normal", "AVG_SHADING_NORMAL|SHADING_NORMAL"},
    {"luxcore", "position", "POSITION"},
    {"luxcore", "depth", "DEPTH:ray"},
    {"luxcore", "albedo", "ALBEDO"},
    {"luxcore", "emission", "EMISSION"},
    {"luxcore", "object_id", "OBJECT_ID"},
    // GBufferFilm; earlier versions write Px for P.X.
    {"pbrt", "color", "R,G,B"},
    {"pbrt", "normal", "Ns|N"},
    {"pbrt", "position", "P"},
    {"pbrt", "albedo", "Albedo"},
    // `emission` and `background` are what the camera sees itself: C[LO] and CB.
    {"arnold", "color", "R,G,B|RGBA|beauty"},
    {"arnold", "normal", "N"},
    {"arnold", "position", "P"},
    {"arnold", "depth", "Z"},
    {"arnold", "albedo", "albedo|denoise_albedo|diffuse_albedo"},
    {"arnold", "emission", "emission+background|emission|background"},
    {"arnold", "object_id", "ID"},
    {"karma", "color", "C|R,G,B|beauty"},
    {"karma", "normal", "N|hitN|normal"},
    {"karma", "position", "P|hitP|position"},
    {"karma", "depth", "hitPz|Pz|depth"},
    {"karma", "albedo", "albedo|basecolor"},
    {"karma", "emission", "visiblelights+directemission|directemission|visiblelights"},
    {"renderman", "color", "Ci|R,G,B|beauty"},
    {"renderman", "normal", "__Nworld|Nworld|Nn|normal|N"},
    {"renderman", "position", "__Pworld|Pworld|P"},
    {"renderman", "depth", "__depth|z|depth|Z"},
    {"renderman", "albedo", "albedo"},
    {"renderman", "object_id", "id"},
};

/// What it costs to be without an image, where that shows.
const char* costOf(const std::string& image) {
  if (image == "albedo") return "textures are blurred";
  if (image == "emission") return "edges of lamps and of the sky are blurred";
  return image == "motion" ? "what moves has no history" : "";
}

/// Our own layout: files are called after their images.
constexpr char kOwnLayout[] = "quell";

std::vector<ChannelSource> ownSourcesOf(const std::string& image) {
  for (const auto& input : kInputs<FrameData>)
    if (input.hasFiles() && image == input.files.role) return parseSources(image, input.files.stem);
  return image == "diffuse" ? parseSources(image, "diffuse_irradiance") : std::vector<ChannelSource>();
}

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> pieces;
  std::istringstream list(text);
  for (std::string piece; std::getline(list, piece, separator);) pieces.push_back(piece);
  if (text.empty() || text.back() == separator) pieces.emplace_back();
  return pieces;
}

constexpr const char* kDepth = factsOf(&FrameData::viewDepth).files.role;
constexpr const char* kMotion = factsOf(&FrameData::motion).files.role;

ChannelSource parseSource(const std::string& image, std::string text) {
  ChannelSource source;
  const std::string whole = text;
  const std::size_t colon = image == kDepth || image == kMotion ? text.rfind(':') : std::string::npos;
  if (colon != std::string::npos) {
    const std::string kind = text.substr(colon + 1);
    if (image == kDepth) source.kind.depth = parseDepthKind(kind);
    if (image == kMotion) source.kind.motion = parseMotionKind(kind);
    text.resize(colon);
  }
  for (const std::string& term : split(text, '+')) source.terms.push_back(split(term, ','));
  for (const std::vector<std::string>& term : source.terms)
    if (std::count(term.begin(), term.end(), "") > 0)
      throw Error(ErrorCode::InvalidArgument,
                  {"open sequence", "--channels", "names with , or + between them", whole});
  return source;
}

}  // namespace

const std::vector<NamedImage>& namedImages() {
  static const std::vector<NamedImage> images = [] {
    std::vector<NamedImage> all;
    for (const auto& input : kInputs<FrameData>)
      all.push_back({input.files.role, input.fileChannels(), costOf(input.files.role)});
    for (const NamedImage& other :
         {NamedImage{"diffuse", 3, ""}, {"transmission_color", 3, ""}, {"alpha", 1, ""}})
      all.push_back(other);
    return all;
  }();
  return images;
}

const NamedImage* findNamedImage(const std::string& name) {
  for (const NamedImage& image : namedImages())
    if (name == image.name) return &image;
  return nullptr;
}

std::vector<ChannelSource> parseSources(const std::string& image, const std::string& text) {
  std::vector<ChannelSource> sources;
  for (const std::string& alternative : split(text, '|')) sources.push_back(parseSource(image, alternative));
  return sources;
}

const std::vector<std::string>& rendererNames() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> found;
    for (const TableRow& row : kTable)
      if (found.empty() || found.back() != row.renderer) found.emplace_back(row.renderer);
    found.emplace_back(kOwnLayout);
    return found;
  }();
  return names;
}

std::vector<ChannelSource> sourcesOf(const std::string& renderer, const std::string& image) {
  if (renderer == kOwnLayout) return ownSourcesOf(image);
  for (const TableRow& row : kTable)
    if (renderer == row.renderer && image == row.image) return parseSources(image, row.sources);
  return {};
}

}  // namespace quell::io

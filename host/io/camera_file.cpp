#include "host/io/camera_file.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "host/io/atomic_file.hpp"
#include "host/io/camera_keys.hpp"
#include "host/io/file_error.hpp"
#include "host/io/look_at.hpp"
#include "host/io/sequence_files.hpp"

namespace quell::io {
namespace {

using nlohmann::json;
using Key = CameraKey;

constexpr char kStage[] = "open sequence";
constexpr std::size_t kMatrixSide = 4;

/// An entry of the file with its name, as "frames[3].eye".
class Entry {
 public:
  Entry(const std::string& path, std::string name, const json& value)
      : m_path(path), m_name(std::move(name)), m_value(value) {}

  [[noreturn]] void refuse(const std::string& expected) const {
    constexpr std::size_t kMost = 60;  // characters
    std::string got = m_value.dump();
    if (got.size() > kMost) got = got.substr(0, kMost) + "...";
    throwFileError(kStage, m_path, m_name.empty() ? expected : fmt::format("{}: {}", m_name, expected), got);
  }
  bool has(Key key) const { return m_value.is_object() && m_value.contains(nameOf(key)); }
  Entry at(Key key, const std::string& expected) const {
    if (!has(key)) throwFileError(kStage, m_path, fmt::format("{}: {}", fullName(key), expected), "none");
    return {m_path, fullName(key), m_value.at(nameOf(key))};
  }
  Entry at(std::size_t index) const {
    return {m_path, fmt::format("{}[{}]", m_name, index), m_value.at(index)};
  }
  std::size_t size() const { return m_value.is_array() ? m_value.size() : 0; }
  bool isList() const { return m_value.is_array(); }

  double number() const {
    if (!m_value.is_number()) refuse("a number");
    return m_value.get<double>();
  }
  double positive(const std::string& expected) const {
    const double value = number();
    if (!(value > 0.0)) refuse(expected);
    return value;
  }
  int frame() const {
    constexpr double kMost = 2147483647.0;
    if (!m_value.is_number_integer() || std::abs(m_value.get<double>()) > kMost) refuse("a whole number");
    return m_value.get<int>();
  }
  std::string choice(const std::vector<std::string>& choices) const {
    for (const std::string& one : choices)
      if (m_value == one) return one;
    std::string expected;
    for (const std::string& one : choices) expected += (expected.empty() ? "\"" : " or \"") + one + "\"";
    refuse(expected);
  }
  template <std::size_t kCount>
  std::array<double, kCount> numbers() const {
    std::array<double, kCount> values{};
    if (size() != kCount) refuse(fmt::format("{} numbers", kCount));
    for (std::size_t i = 0; i < kCount; ++i) values[i] = at(i).number();
    return values;
  }
  /// 4 rows of 4 numbers, or 16 numbers row by row.
  Matrix4 matrix() const {
    Matrix4 values{};
    if (size() == values.size() && !m_value[0].is_array()) return numbers<16>();
    if (size() != kMatrixSide) refuse("4 rows of 4 numbers");
    for (std::size_t row = 0; row < kMatrixSide; ++row) {
      const auto numbers = at(row).numbers<kMatrixSide>();
      for (std::size_t column = 0; column < kMatrixSide; ++column)
        values[kMatrixSide * row + column] = numbers[column];
    }
    return values;
  }

 private:
  std::string fullName(Key key) const { return (m_name.empty() ? "" : m_name + ".") + nameOf(key); }

  const std::string& m_path;
  std::string m_name;
  const json& m_value;
};

/// What holds for all frames: an entry of the frame, else one of the file.
class FrameEntry {
 public:
  FrameEntry(const Entry& frame, const Entry& file) : m_frame(frame), m_file(file) {}
  bool has(Key key) const { return m_frame.has(key) || m_file.has(key); }
  Entry at(Key key, const std::string& expected) const {
    return !m_frame.has(key) && m_file.has(key) ? m_file.at(key, expected) : m_frame.at(key, expected);
  }
  const Entry& own() const { return m_frame; }

 private:
  const Entry &m_frame, &m_file;
};

FovAxis fovAxis(const FrameEntry& entry) {
  if (!entry.has(Key::FovAxis)) return FovAxis::Y;
  const std::string name = entry.at(Key::FovAxis, "").choice({"x", "y", "smaller", "larger"});
  return name == "x"         ? FovAxis::X
         : name == "y"       ? FovAxis::Y
         : name == "smaller" ? FovAxis::Smaller
                             : FovAxis::Larger;
}

Matrix4 lookAtOf(const FrameEntry& entry, double aspect) {
  LookAt view;
  view.eye = entry.at(Key::Eye, "3 numbers").numbers<3>();
  view.target = entry.at(Key::Target, "3 numbers, the point looked at").numbers<3>();
  view.up = entry.at(Key::Up, "3 numbers, the direction that is up in the picture").numbers<3>();
  view.fovDegrees =
      entry.at(Key::Fov, "degrees above 0 and below 180").positive("degrees above 0 and below 180");
  if (!(view.fovDegrees < 180.0)) entry.at(Key::Fov, "").refuse("degrees above 0 and below 180");
  view.axis = fovAxis(entry);
  if (entry.has(Key::Aspect)) aspect = entry.at(Key::Aspect, "").positive("width by height, above 0");
  const auto matrix = lookAtMatrix(view, aspect);
  if (!matrix)
    entry.own().refuse("\"eye\" apart from \"target\", and \"up\" not along the line between them");
  return *matrix;
}

/// `reading`: how the file's matrices are meant.
Matrix4 matrixOf(const FrameEntry& entry, const MatrixReading& reading, double aspect) {
  const Entry& own = entry.own();
  if (own.has(Key::ViewProjection)) return readAs(reading, own.at(Key::ViewProjection, "").matrix());
  if (own.has(Key::Eye)) return lookAtOf(entry, aspect);
  if (!own.has(Key::View))
    own.refuse(
        "\"view_projection\", or \"view\" and \"projection\", or \"eye\", \"target\", \"up\" and \"fov\"");
  const MatrixReading order{"", reading.transposed, false};
  const Matrix4 view = readAs(order, own.at(Key::View, "").matrix());
  const Matrix4 projection =
      readAs(order, entry.at(Key::Projection, "4 rows of 4 numbers beside \"view\"").matrix());
  return readAs({"", false, reading.yDown}, product(projection, view));
}

DepthRange rangeOf(const FrameEntry& entry) {
  DepthRange range;
  range.near = entry.at(Key::Near, "a distance above 0").positive("a distance above 0");
  if (!entry.has(Key::Far)) return range;
  range.far = entry.at(Key::Far, "").number();
  if (!(*range.far > range.near)) entry.at(Key::Far, "").refuse("a distance above \"near\"");
  return range;
}

MatrixReading readingOf(const Entry& file) {
  MatrixReading reading = matrixReadings().front();
  if (file.has(Key::Vectors))
    reading.transposed = file.at(Key::Vectors, "").choice({"column", "row"}) == "row";
  if (file.has(Key::NdcY)) reading.yDown = file.at(Key::NdcY, "").choice({"up", "down"}) == "down";
  return reading;
}

/// Adds one frame; the camera before it is set where the entry has it.
void addFrame(CameraFile& cameras, std::map<int, bool>& hasPrevious, const FrameEntry& entry,
              const MatrixReading& reading, double aspect, const std::string& path) {
  const Entry number = entry.own().at(Key::Frame, "the number of the frame");
  const int frame = number.frame();
  if (cameras.cameras.count(frame) > 0) number.refuse("a frame that no other entry has");
  Camera camera;
  camera.worldToClip = matrixOf(entry, reading, aspect);
  constexpr Key kPrevious = Key::PreviousViewProjection;
  hasPrevious[frame] = entry.own().has(kPrevious);
  if (hasPrevious[frame]) camera.worldToClipPrev = readAs(reading, entry.own().at(kPrevious, "").matrix());
  if (entry.own().has(Key::JitterPx)) camera.jitterPx = entry.own().at(Key::JitterPx, "").numbers<2>();
  requireJitter(path, nameOf(Key::JitterPx), frame, camera.jitterPx);
  cameras.cameras[frame] = camera;
  if (entry.has(Key::Near) || entry.has(Key::Far)) cameras.ranges[frame] = rangeOf(entry);
}

json parseFile(const std::string& path) {
  try {
    return json::parse(readFile(path));
  } catch (const json::exception& error) {
    throwFileError(kStage, path, "a JSON document", error.what());
  }
}

}  // namespace

CameraFile readCameraFile(const std::string& path, double aspect) {
  const json document = parseFile(path);
  const Entry file(path, "", document);
  const Entry frames = file.at(Key::Frames, "a list of frames");
  if (!frames.isList()) frames.refuse("a list of frames");
  const MatrixReading reading = readingOf(file);
  CameraFile result;
  result.declared = file.has(Key::Vectors) || file.has(Key::NdcY);
  std::map<int, bool> hasPrevious;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const Entry frame = frames.at(i);
    addFrame(result, hasPrevious, FrameEntry(frame, file), reading, aspect, path);
  }
  for (auto& [frame, camera] : result.cameras) {
    if (hasPrevious[frame]) continue;
    const auto before = result.cameras.find(frame - 1);
    camera.worldToClipPrev = before == result.cameras.end() ? camera.worldToClip : before->second.worldToClip;
  }
  return result;
}

void requireCameras(const CameraFile& file, const std::vector<int>& frames, const std::string& path) {
  for (const int frame : frames)
    if (file.cameras.count(frame) == 0)
      throwFileError(kStage, path, fmt::format("a camera of frame {}", frame), "none");
}

}  // namespace quell::io

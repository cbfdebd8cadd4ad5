#include "host/io/exr_camera.hpp"

#include <ImfHeader.h>
#include <ImfMatrixAttribute.h>

#include <algorithm>
#include <cmath>

#include "host/io/camera_convention.hpp"

namespace quell::io {
namespace {

/// The attribute as column vectors have it, if it was written for row vectors, as Imath's are.
std::optional<Matrix4> matrixOf(const Imf::Header& header, const char* name) {
  const auto* attribute = header.findTypedAttribute<Imf::M44fAttribute>(name);
  if (attribute == nullptr) return std::nullopt;
  Matrix4 matrix{};
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 4; ++column)
      matrix[std::size_t(4 * row + column)] = double(attribute->value()[column][row]);
  const bool finite =
      std::all_of(matrix.begin(), matrix.end(), [](double value) { return std::isfinite(value); });
  return finite ? std::optional(matrix) : std::nullopt;
}

/// row = scale * row + shift * row 3.
void setRow(Matrix4& matrix, std::size_t row, double scale, double shift) {
  for (std::size_t column = 0; column < 4; ++column)
    matrix[4 * row + column] = scale * matrix[4 * row + column] + shift * matrix[12 + column];
}

/// NDC of another range or sense to those of quell::Camera.
struct NdcForm {
  double scaleX, scaleY;
  double shiftX, shiftY;
};

void addNdcCameras(std::vector<Matrix4>& all, const Matrix4& worldToNdc, double aspect) {
  const double wide = std::max(aspect, 1.0), tall = std::max(1.0 / aspect, 1.0);
  const NdcForm forms[] = {
      {1.0, 1.0, 0.0, 0.0},                                // -1 to 1, y up
      {2.0, -2.0, -1.0, 1.0},                              // 0 to 1, y down: RenderMan
      {2.0, 2.0, -1.0, -1.0},                              // 0 to 1, y up
      {1.0, -1.0, 0.0, 0.0},                               // -1 to 1, y down
      {1.0 / wide, 1.0 / tall, 0.0, 0.0},                  // the shorter side from -1 to 1
      {2.0 / wide, 2.0 / tall, -1.0 / wide, -1.0 / tall},  // the same from 0 to 1: pbrt
      {2.0 / wide, -2.0 / tall, -1.0 / wide, 1.0 / tall},
  };
  for (const NdcForm& form : forms) {
    all.push_back(worldToNdc);
    setRow(all.back(), 0, form.scaleX, form.shiftX);
    setRow(all.back(), 1, form.scaleY, form.shiftY);
  }
}

void addViewCameras(std::vector<Matrix4>& all, const Matrix4& worldToCamera, const Imf::Header& header,
                    double aspect) {
  const double width = double(header.screenWindowWidth());
  if (!(width > 0.0)) return;
  for (const double axis : {1.0, -1.0}) {
    for (const double up : {1.0, -1.0}) {
      Matrix4 matrix = worldToCamera;
      for (std::size_t column = 0; column < 4; ++column)
        matrix[12 + column] = axis * worldToCamera[8 + column];
      setRow(matrix, 0, 2.0 / width, -2.0 * double(header.screenWindowCenter().x) / width);
      setRow(matrix, 1, 2.0 * up * aspect / width,
             -2.0 * double(header.screenWindowCenter().y) * aspect / width);
      all.push_back(matrix);
    }
  }
}

Matrix4 transposed(const Matrix4& matrix) { return readAs({"", true, false}, matrix); }

}  // namespace

std::vector<Matrix4> headerCameras(const ExrHeader& header) {
  std::vector<Matrix4> all;
  if (!header.attributes) return all;
  const double aspect = double(header.windows.display.width) / header.windows.display.height;
  const auto ndc = matrixOf(*header.attributes, "worldToNDC");
  const auto view = matrixOf(*header.attributes, "worldToCamera");
  if (ndc) addNdcCameras(all, *ndc, aspect);
  if (view) addViewCameras(all, *view, *header.attributes, aspect);
  if (ndc) addNdcCameras(all, transposed(*ndc), aspect);
  if (view) addViewCameras(all, transposed(*view), *header.attributes, aspect);
  for (Matrix4& matrix : all) matrix = cropped({matrix, matrix, {}}, header.windows).worldToClip;
  return all;
}

std::optional<std::size_t> fittingCamera(const std::vector<Matrix4>& cameras, const Image& positionWorld) {
  for (std::size_t i = 0; i < cameras.size(); ++i) {
    const auto error = projectionErrorPx(cameras[i], {}, positionWorld);
    if (!error || fits(*error, positionWorld)) return i;
  }
  return std::nullopt;
}

}  // namespace quell::io

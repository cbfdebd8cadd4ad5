#include <algorithm>
#include <array>
#include <quell/camera.hpp>

#include "host/c_api/boundary.hpp"

namespace quell::c_api {
namespace {

MatrixOrder toOrder(quell_matrix_order order, const char* function) {
  if (order == QUELL_ROWS) return MatrixOrder::Rows;
  if (order == QUELL_COLUMNS) return MatrixOrder::Columns;
  throw Error(ErrorCode::InvalidArgument,
              {function, "order", "QUELL_ROWS or QUELL_COLUMNS", std::to_string(order)});
}

std::array<double, 3> toPoint(const double* given, const char* function, const char* argument) {
  require(given, function, argument);
  return {given[0], given[1], given[2]};
}

void assign(quell_camera& camera, const Matrix4& worldToClip) {
  std::copy(worldToClip.begin(), worldToClip.end(), camera.worldToClip);
}

}  // namespace
}  // namespace quell::c_api

using namespace quell::c_api;

extern "C" {

quell_status quellSetMatrices(quell_camera* camera, const float* viewToClip, const float* worldToView,
                              quell_matrix_order order) {
  return guarded("quellSetMatrices", [&] {
    require(camera, "quellSetMatrices", "camera");
    require(viewToClip, "quellSetMatrices", "viewToClip");
    const quell::MatrixOrder lies = toOrder(order, "quellSetMatrices");
    const quell::Matrix4 clip = quell::toMatrix4(viewToClip, lies);
    assign(*camera,
           worldToView == nullptr ? clip : quell::product(clip, quell::toMatrix4(worldToView, lies)));
  });
}

quell_status quellSetLookAt(quell_camera* camera, const double eye[3], const double target[3],
                            const double up[3], double verticalFovDegrees, double aspect) {
  return guarded("quellSetLookAt", [&] {
    require(camera, "quellSetLookAt", "camera");
    assign(*camera,
           quell::lookAt(toPoint(eye, "quellSetLookAt", "eye"), toPoint(target, "quellSetLookAt", "target"),
                         toPoint(up, "quellSetLookAt", "up"), verticalFovDegrees, aspect));
  });
}

}  // extern "C"

// Host side of the stage import_image.
#pragma once

#include <string>

#include "host/core/image_schema.hpp"
#include "host/core/imported_images.hpp"
#include "host/core/stage.hpp"
#include "kernels/import_image_params.h"

namespace quell {

/// See kernels/import_image.cl for what it computes. One stage an image.
class ImportImage : public Stage {
 public:
  explicit ImportImage(const ImageMember<Frame, ImageView>& image)
      : m_image(image), m_buffer(importedBuffer(image.name)) {}

  std::string name() const override { return "import_image"; }
  std::string label() const override { return name() + " (" + m_image.name + ")"; }
  std::vector<Port> ports(const Configuration& configuration, const Content& content = {}) const override;
  void build(const KernelBuilder& builder) override;
  void enqueue(FrameRun& run) override;

 private:
  ImportImageParams params(const FrameRun& run) const;

  const ImageMember<Frame, ImageView>& m_image;
  std::string m_buffer;
  BoundKernel m_kernel;
  cl::NDRange m_workGroup;
};

/// Puts in front of a method's table what brings in those of the images it reads that have to be.
void addImports(Schedule& table, const Configuration& configuration);

}  // namespace quell

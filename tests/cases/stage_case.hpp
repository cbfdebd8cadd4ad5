// A case: one description of a stage's inputs that drives its unit test and its bench entry, so that they
// cannot disagree.
#pragma once

#include <cstdint>

#include "host/stages/fit_features.hpp"
#include "tests/cases/holes.hpp"
#include "tests/support/comparison.hpp"
#include "tests/support/image_layout.hpp"
#include "tests/support/stage_harness.hpp"

namespace quell::tests {

/// The setting `skip`; on, the inputs have holes of background, and rays may be jittered.
enum class Skip { Off, On, OnJittered };

/// What all cases have in common.
struct CaseOptions {
  Size size{33, 31};
  Mapping mapping = Mapping::Automatic;
  std::array<int, 2> workGroup{0, 0};
  int fitGroup = 0;
  unsigned seed = 1;
  std::string features = kDefaultFeatures;  ///< of the fit
  ImageLayout layout = packed(3);           ///< of the caller's images, where the stage touches any
  Skip skip = Skip::Off;

  /// Whether the test scene has holes; see renderScene().
  bool holes() const { return skip != Skip::Off; }
};

/// Inputs in units of light, or of its square.
struct LightInput {
  float* values;
  std::size_t count;
  int power = 1;
};
LightInput lightOf(Planes& planes, int power = 1);
LightInput lightOf(io::Image& image);
/// Luminance and its square, in QUELL_MOMENT_PLANES a signal.
std::vector<LightInput> momentsOf(Planes& moments);

class StageCase {
 public:
  virtual ~StageCase() = default;

  /// Sends the inputs to the device.
  virtual void upload() = 0;
  /// Runs the stage once; device time in milliseconds.
  double run() { return m_harness.run(m_reprojection, m_frameIndex); }
  void uploadAndRun() {
    upload();
    m_holes.dig(m_harness);
    run();
  }
  /// Device against oracle, after run().
  virtual Comparison compare() = 0;
  /// Largest error that compare() may report.
  virtual double tolerance() const = 0;
  Comparison check();
  /// The same with all light that goes in multiplied: errors are relative to that, then. Only after check(), which
  /// brings images into the caller's layout. Leaves inputs and outputs as they were.
  Comparison checkInLight(double factor);
  Size size() const { return m_harness.size(); }
  std::uint64_t bytesMoved() const { return m_harness.bytesMoved(); }
  double bytesPerPixel() const;

  StageHarness& harness() { return m_harness; }
  /// Pixels that the stage leaves out, null if none: no oracle says anything about them.
  const BasicPlanes<char>* leftOut() const { return m_holes.leftOut(); }

 protected:
  StageCase(const std::string& stem, const StageSetup& setup) : m_harness(stem, setup), m_holes(m_harness) {}

  /// Of the inputs, as far as the stage sees any.
  virtual std::vector<LightInput> light() { return {}; }
  /// Of what comes out: cases make up light of the order of 1.
  double lightUnit() const { return m_lightUnit; }
  /// Against the oracle's, each moment in its own unit.
  void compareMoments(Comparison& comparison, const Planes& device, const ExactPlanes& exact,
                      const BasicPlanes<char>* excluded, const ExactPlanes* scales = nullptr) const;

  StageHarness m_harness;
  Holes m_holes;
  ReprojectionParams m_reprojection{};
  std::uint32_t m_frameIndex = 1;

 private:
  double m_lightUnit = 1.0;
};

/// Largest share of pixels that a case may leave out because they are within rounding of a decision.
constexpr double kExcludedShare = 0.01;

/// Rounding to half, relative: 11 significant bits.
constexpr double kHalfRounding = 1.0 / 2048;
/// What storing a result in this layout adds to its error.
double storageError(const ImageLayout& layout);

/// Size, mapping, work-groups and features of the options, with those images that the features are made of.
StageSetup makeSetup(const CaseOptions& options);

/// The weights of the guides, where the stage reads such of its own.
void uploadTapWeights(StageHarness& harness, const Planes& guides);

/// The three colours of one of the caller's images.
Planes outputPlanes(const StageHarness& harness, ImageView Output::*image);

/// Compares one of the caller's images with the planes that it should hold: a fourth component must be 1 and
/// bytes that belong to no component untouched. The last arguments are those of comparePixels().
void compareOutput(Comparison& comparison, const StageHarness& harness, ImageView Output::*image,
                   const ExactPlanes& exact, const BasicPlanes<char>* excluded = nullptr,
                   const ExactPlanes* scales = nullptr, double unit = 1.0);

}  // namespace quell::tests

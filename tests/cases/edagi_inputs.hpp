// What the cases of the stages of edagi have in common.
#pragma once

#include "tests/cases/filter_inputs.hpp"

namespace quell::tests {

/// Which images the caller has.
struct EdagiVariant {
  int signals = 2;
  bool roughness = true;
  bool hitDistance = true;
};

/// Settings of edagi other than the defaults.
StageSetup makeEdagiSetup(const CaseOptions& options, const EdagiVariant& variant = {});

}  // namespace quell::tests

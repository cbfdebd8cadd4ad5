#include "host/cli/common/fair_rounds.hpp"

namespace quell::cli {

CopyBandwidth measureCopy(const DenoiseSession& session) {
  return measureCopyBandwidth(session.context(), session.deviceId(), session.queue());
}

const std::optional<io::Reference>& References::of(int frame) {
  if (m_frame != frame) {
    m_reference = m_sequence.reference(frame);
    m_frame = frame;
  }
  return m_reference;
}

}  // namespace quell::cli

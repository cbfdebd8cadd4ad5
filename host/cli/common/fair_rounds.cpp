#include "host/cli/common/fair_rounds.hpp"

namespace quell::cli {

bool isRefusal(const Error& error) {
  return error.code() == ErrorCode::InvalidArgument || error.code() == ErrorCode::OutOfRange;
}

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

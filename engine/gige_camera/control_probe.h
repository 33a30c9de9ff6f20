#pragma once
// Whether a GigE Vision device answers at an address, asked in one datagram: Aravis needs three seconds to say no.

#include <chrono>
#include <string>

namespace vignole::gige {

/// Reads its version register, which every device lets everybody read.
[[nodiscard]] bool answers(const std::string& address, std::chrono::milliseconds patience);

}  // namespace vignole::gige

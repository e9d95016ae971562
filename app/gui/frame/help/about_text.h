#pragma once

#include <QString>

namespace noonmark {

/// Version, build, libraries, instruction set and graphics, as plain text to be copied into a report of a
/// fault.
QString makeAboutText();

}  // namespace noonmark

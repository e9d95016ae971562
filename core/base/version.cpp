#include "core/base/version.h"

namespace noonmark {

std::string_view version() { return NOONMARK_VERSION; }

}  // namespace noonmark

#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace noonmark {

/// The names that a user who typed `text` may have meant: those that differ by few letters, as a whole or in
/// their last part ("New_York"). Best first.
std::vector<std::string> findCloseNames(std::string_view text, const std::vector<std::string>& names,
                                        std::size_t most = 3);

}  // namespace noonmark

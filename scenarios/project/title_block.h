#pragma once

#include <cstddef>
#include <string>

#include "core/base/result.h"

namespace noonmark {

/// What the title block of every sheet states about the project. Text in UTF-8 of one line; an empty text is
/// left out.
struct TitleBlock {
    std::string project;
    std::string author;
    std::string client;
    std::string date;         ///< as it shall be printed; empty: the day on which the sheets are made
    std::string sheetPrefix;  ///< "A-" numbers the sheets A-1, A-2, ...
    std::string logo;         ///< the bytes of a PNG or JPEG picture; empty: none
    bool operator==(const TitleBlock&) const = default;

    static constexpr std::size_t maxBytesOfText = 800;  ///< of each text
    static constexpr std::size_t maxBytesOfLogo = std::size_t{1} << 20U;
};

/// Error: a text that is too long or holds control characters, or a logo that is too large or neither PNG nor
/// JPEG by its first bytes.
Result<void> validate(const TitleBlock& block);

/// The bytes of a picture for the title block; validate() checks what they are. Error: no plain file, or too
/// large.
Result<std::string> readLogo(const std::string& file);

}  // namespace noonmark

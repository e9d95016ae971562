#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace noonmark {

/// What the title block of every sheet states about the project. Text in UTF-8, at most 200 characters each;
/// an empty text is left out.
struct TitleBlock {
    std::string project;
    std::string author;
    std::string client;
    std::string date;         ///< as it shall be printed; empty: the day on which the sheets are made
    std::string sheetPrefix;  ///< "A-" numbers the sheets A-1, A-2, ...
    std::vector<std::uint8_t> logo;  ///< a PNG or JPEG picture of at most 1 MiB; empty: none
    bool operator==(const TitleBlock&) const = default;
};

}  // namespace noonmark

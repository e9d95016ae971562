#include "scenarios/project/title_block.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string_view>

#include "core/describe/field_values.h"
#include "core/io/files/plain_file.h"
#include "scenarios/project/title_fields.h"

namespace noonmark {

namespace {

bool isPrintable(const std::string& text) {
    return std::ranges::none_of(text, [](char c) { return static_cast<unsigned char>(c) < ' ' || c == 127; });
}

bool isPicture(std::string_view bytes) {
    using namespace std::string_view_literals;
    return bytes.starts_with("\x89PNG\r\n\x1a\n"sv) || bytes.starts_with("\xff\xd8\xff"sv);
}

}  // namespace

Result<void> validate(const TitleBlock& block) {
    for (const Field& field : titleFields().rows())
        if (const std::string text = formatText(field.get(&block));
            text.size() > TitleBlock::maxBytesOfText || !isPrintable(text))
            return failure("A text of the title block is too long or holds control characters", "title block",
                           "Use one line of at most 200 characters");
    if (!block.logo.empty() && (block.logo.size() > TitleBlock::maxBytesOfLogo || !isPicture(block.logo)))
        return failure("The logo is not a PNG or JPEG picture of at most 1 MiB", "title block",
                       "Choose another picture, or export this one smaller");
    return {};
}

Result<std::string> readLogo(const std::string& file) {
    if (auto plain = checkPlainFile(file); !plain) return tl::make_unexpected(plain.error());
    std::error_code error;
    const auto bytes = std::filesystem::file_size(file, error);
    if (error) return failure("The logo cannot be read: " + error.message(), file);
    if (bytes > TitleBlock::maxBytesOfLogo)
        return failure("The logo has more than 1 MiB", file, "Give a smaller PNG or JPEG picture");
    std::ifstream stream(file, std::ios::binary);
    return std::string{std::istreambuf_iterator<char>(stream), {}};
}

}  // namespace noonmark

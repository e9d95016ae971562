#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace noonmark::tests {

/// Writes ZIP archives byte by byte, so that tests can lie in them. Files are stored, not deflated.
class ZipMaker {
public:
    /// `packed`: by deflate, of `size` bytes; else as it is.
    void add(const std::string& name, std::string_view content, std::uint16_t flags = 0) {
        addEntry(name, content, content.size(), crcOf(content), 0, flags);
    }
    void addDeflated(const std::string& name, std::string_view packed, std::size_t size, std::uint32_t crc) {
        addEntry(name, packed, size, crc, 8, 0);
    }
    [[nodiscard]] std::string text() const {
        std::string end = "PK\5\6";
        end += word(0, 2) + word(0, 2) + word(count_, 2) + word(count_, 2) + word(directory_.size(), 4) +
               word(files_.size(), 4) + word(0, 2);
        return files_ + directory_ + end;
    }

    static std::uint32_t crcOf(std::string_view content) {
        std::uint32_t crc = 0xFFFFFFFFU;
        for (const char c : content) {
            crc ^= static_cast<unsigned char>(c);
            for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1U) ^ ((crc & 1U) != 0 ? 0xEDB88320U : 0U);
        }
        return ~crc;
    }

private:
    static std::string word(std::size_t value, int bytes) {
        std::string text;
        for (int i = 0; i < bytes; ++i) text += char((value >> (8U * unsigned(i))) & 0xFFU);
        return text;
    }
    void addEntry(const std::string& name, std::string_view packed, std::size_t size, std::uint32_t crc,
                  std::uint16_t method, std::uint16_t flags) {
        const std::string common = word(20, 2) + word(flags, 2) + word(method, 2) + word(0, 4) +
                                   word(crc, 4) + word(packed.size(), 4) + word(size, 4) +
                                   word(name.size(), 2) + word(0, 2);
        directory_ += "PK\1\2" + word(20, 2) + common + word(0, 2) + word(0, 2) + word(0, 2) + word(0, 4) +
                      word(files_.size(), 4) + name;
        files_ += "PK\3\4" + common + name;
        files_ += packed;
        ++count_;
    }

    std::string files_, directory_;
    std::size_t count_ = 0;
};

}  // namespace noonmark::tests

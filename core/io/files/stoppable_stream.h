#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <istream>
#include <stop_token>
#include <streambuf>

namespace noonmark {

/// A file that is at its end after a stop request, so that a parser which cannot be stopped gives up. Whoever
/// reads it asks the token whether the end was the file's own. It cannot be rewound.
class StoppableStream : private std::streambuf, public std::istream {
public:
    /// Without a token it ends with the StopScope of this thread.
    explicit StoppableStream(const std::filesystem::path& file, std::stop_token stop = {});

    [[nodiscard]] bool opened() const { return file_.is_open(); }
    /// Of the file, 0..1.
    [[nodiscard]] double share() const { return double(taken_) / double(bytes_); }

private:
    std::streambuf::int_type underflow() override;

    std::ifstream file_;
    std::stop_token stop_;
    std::uintmax_t bytes_ = 1, taken_ = 0;
    std::array<char, 1U << 16U> piece_{};
};

}  // namespace noonmark

#include "core/io/files/stoppable_stream.h"

#include <algorithm>
#include <utility>

#include "core/base/stop_scope.h"

namespace noonmark {

StoppableStream::StoppableStream(const std::filesystem::path& file, std::stop_token stop)
    : std::istream(static_cast<std::streambuf*>(this)),
      file_(file, std::ios::binary),
      stop_(std::move(stop)) {
    std::error_code error;
    const std::uintmax_t bytes = std::filesystem::file_size(file, error);
    if (!error) bytes_ = std::max<std::uintmax_t>(1, bytes);
}

std::streambuf::int_type StoppableStream::underflow() {
    if (stop_.stop_requested() || StopScope::isStopped()) return std::streambuf::traits_type::eof();
    file_.read(piece_.data(), std::streamsize(piece_.size()));
    const std::streamsize count = file_.gcount();
    if (count == 0) return std::streambuf::traits_type::eof();
    taken_ += std::uintmax_t(count);
    setg(piece_.data(), piece_.data(), piece_.data() + count);
    return std::streambuf::traits_type::to_int_type(*gptr());
}

}  // namespace noonmark

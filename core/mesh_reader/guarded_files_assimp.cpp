#include <assimp/IOStream.hpp>
#include <assimp/IOSystem.hpp>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "core/mesh_reader/guarded_files.h"
#include "core/mesh_reader/mesh_file_check.h"

namespace noonmark {

namespace {

constexpr std::size_t maxReadsAtEnd = 100;
constexpr std::size_t maxTimesOver =
    100;  // a reader may read a file a few times, to find its format and then its content

class GuardedStream final : public Assimp::IOStream {
public:
    GuardedStream(std::unique_ptr<std::istream> stream, std::size_t size)
        : source_(std::move(stream)), stream_(*source_), size_(size) {}

    size_t Read(void* buffer, size_t size, size_t count) override {
        stream_.clear();
        stream_.read(static_cast<char*>(buffer), std::streamsize(size * count));
        const auto got = std::size_t(stream_.gcount());
        countRead(got);
        return size == 0 ? 0 : got / size;
    }
    size_t Write(const void*, size_t, size_t) override { return 0; }
    aiReturn Seek(size_t offset, aiOrigin origin) override {
        stream_.clear();
        const auto from = origin == aiOrigin_SET   ? std::ios::beg
                          : origin == aiOrigin_CUR ? std::ios::cur
                                                   : std::ios::end;
        if (origin == aiOrigin_SET && offset > size_) return aiReturn_FAILURE;
        stream_.seekg(std::streamoff(offset), from);
        return stream_ ? aiReturn_SUCCESS : aiReturn_FAILURE;
    }
    [[nodiscard]] size_t Tell() const override { return std::size_t(stream_.tellg()); }
    [[nodiscard]] size_t FileSize() const override { return size_; }
    void Flush() override {}

private:
    void countRead(std::size_t got) {
        readInAll_ += got;
        readsAtEnd_ += got == 0 ? 1 : 0;
        const bool readsInCircles = readsAtEnd_ > maxReadsAtEnd || readInAll_ / maxTimesOver > size_ + 65536;
        if (readsInCircles) throw std::runtime_error("the file ends early");
    }

    std::unique_ptr<std::istream> source_;
    std::istream& stream_;
    std::size_t size_ = 0;
    std::size_t readInAll_ = 0;
    std::size_t readsAtEnd_ = 0;
};

class GuardedFiles final : public Assimp::IOSystem {
public:
    GuardedFiles(std::filesystem::path mesh, std::string content)
        : mesh_(std::move(mesh)), content_(std::move(content)) {}
    bool Exists(const char* path) const override { return path == mesh_ || isPlainFileBeside(path, mesh_); }
    [[nodiscard]] char getOsSeparator() const override {
        return char(std::filesystem::path::preferred_separator);
    }
    Assimp::IOStream* Open(const char* path, const char*) override {
        if (!Exists(path)) return nullptr;
        if (path == mesh_ && !content_.empty())
            return new GuardedStream(std::make_unique<std::istringstream>(content_), content_.size());
        auto stream = std::make_unique<std::ifstream>(path, std::ios::binary);
        if (!stream->is_open()) return nullptr;
        std::error_code error;
        const auto size = std::filesystem::file_size(path, error);
        return new GuardedStream(std::move(stream), error ? 0 : std::size_t(size));
    }
    void Close(Assimp::IOStream* stream) override { delete stream; }

private:
    std::filesystem::path mesh_;
    std::string content_;
};

}  // namespace

std::unique_ptr<Assimp::IOSystem> guardedFiles(const std::filesystem::path& mesh, std::string content) {
    return std::make_unique<GuardedFiles>(mesh, std::move(content));
}

}  // namespace noonmark

#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>

namespace noonmark {

/// Cuts an OpenStreetMap PBF file at its blocks, so that a library which cannot be stopped reads it in pieces
/// of some 0.1 s each. Backend: pbf_pieces_protozero.cpp.
class PbfPieces {
public:
    /// Throws std::runtime_error if the file's first block cannot be read.
    explicit PbfPieces(const std::filesystem::path& file);

    /// The header block and the next data blocks: up to 2 MB as they are stored or 32 MB unpacked, but at
    /// least one. Empty after the last. Throws std::runtime_error: the file is cut off or damaged; a block
    /// unpacks to 200 times its size, as no map does.
    std::string next();

    [[nodiscard]] double share() const { return double(taken_) / double(bytes_); }  ///< of the file, 0..1

private:
    struct Block {
        std::string bytes;              // with its head
        std::size_t unpackedBytes = 0;  // as it states
    };
    Block readBlock();
    std::string readBytes(std::size_t count);

    std::ifstream stream_;
    std::uintmax_t bytes_ = 0;
    std::uintmax_t taken_ = 0;
    std::string header_;
};

}  // namespace noonmark

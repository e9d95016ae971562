#include <fmt/format.h>

#include <protozero/pbf_reader.hpp>
#include <stdexcept>

#include "core/io/osm/osm_map.h"

namespace noonmark {

namespace {

// The format's own limits, wiki.openstreetmap.org/wiki/PBF_Format.
constexpr std::size_t maxHeadBytes = 64 * 1024;
constexpr std::size_t maxBlockBytes = 32 * 1024 * 1024;

constexpr std::size_t pieceBytes = 2'000'000;
constexpr std::size_t pieceUnpackedBytes = maxBlockBytes;

// Fields of the format's messages BlobHeader and Blob.
constexpr protozero::pbf_tag_type dataSizeField = 3;
constexpr protozero::pbf_tag_type rawSizeField = 2;

// The last value of a field of numbers; 0 if it is absent.
std::size_t findNumber(const std::string& message, protozero::pbf_tag_type field) {
    std::size_t number = 0;
    protozero::pbf_reader reader(message);
    while (reader.next())
        if (reader.tag() == field && reader.wire_type() == protozero::pbf_wire_type::varint)
            number = std::size_t(std::max(0, reader.get_int32()));
        else
            reader.skip();
    return number;
}

void checkUnpacked(std::size_t unpacked, std::size_t stored) {
    constexpr std::size_t harmless = 4'000'000, maxTimes = 200;
    if (unpacked > harmless && unpacked / maxTimes > stored)
        throw std::runtime_error(fmt::format("a block of {} bytes unpacks to {} million, {} times as many",
                                             stored, unpacked / 1'000'000, unpacked / stored));
}

}  // namespace

PbfPieces::PbfPieces(const std::filesystem::path& file) : stream_(file, std::ios::binary) {
    bytes_ = std::max<std::uintmax_t>(1, std::filesystem::file_size(file));
    header_ = readBlock().bytes;
}

std::string PbfPieces::next() {
    std::string piece = header_;
    std::size_t unpacked = 0;
    while (piece.size() < header_.size() + pieceBytes && unpacked < pieceUnpackedBytes) {
        const Block block = readBlock();
        if (block.bytes.empty()) break;
        piece += block.bytes;
        unpacked += block.unpackedBytes;
    }
    return piece.size() > header_.size() ? piece : std::string();
}

// Four bytes with the size of the head, the head with the size of the block, the block. Empty at the end.
PbfPieces::Block PbfPieces::readBlock() {
    if (stream_.peek() == std::ifstream::traits_type::eof()) return {};
    const std::string size = readBytes(4);
    std::size_t headBytes = 0;
    for (const char byte : size) headBytes = headBytes * 256 + static_cast<unsigned char>(byte);
    if (headBytes > maxHeadBytes) throw std::runtime_error("the head of a block is too large");
    const std::string head = readBytes(headBytes);
    const std::size_t blockBytes = findNumber(head, dataSizeField);
    if (blockBytes == 0 || blockBytes > maxBlockBytes) throw std::runtime_error("a block's size is wrong");
    const std::string block = readBytes(blockBytes);
    const std::size_t unpacked = findNumber(block, rawSizeField);
    checkUnpacked(unpacked, blockBytes);
    return {size + head + block, unpacked};
}

std::string PbfPieces::readBytes(std::size_t count) {
    std::string bytes(count, '\0');
    if (!stream_.read(bytes.data(), std::streamsize(count))) throw std::runtime_error("its end is missing");
    taken_ += count;
    return bytes;
}

}  // namespace noonmark

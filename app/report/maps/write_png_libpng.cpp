#include <png.h>

#include <algorithm>
#include <csetjmp>
#include <vector>

#include "app/report/maps/write_png.h"

namespace noonmark {

namespace {

void writeBytes(png_structp png, png_bytep bytes, std::size_t size) {
    auto* device = static_cast<QIODevice*>(png_get_io_ptr(png));
    if (device->write(reinterpret_cast<const char*>(bytes), qint64(size)) != qint64(size))
        png_error(png, "the device is full");
}

void ignoreFlush(png_structp) {}

void ignoreMessage(png_structp, png_const_charp) {}

// Without it, libpng prints the message.
void jumpOut(png_structp png, png_const_charp) { png_longjmp(png, 1); }

bool isAscii(const std::string& text) {
    return std::ranges::all_of(text, [](char c) { return static_cast<unsigned char>(c) < 0x80; });
}

// libpng only reads through the pointers.
std::vector<png_text> makeChunks(const FileTags& tags) {
    std::vector<png_text> chunks;
    for (const auto& [name, text] : tags) {
        png_text& chunk = chunks.emplace_back();
        chunk.compression = isAscii(text) ? PNG_TEXT_COMPRESSION_NONE : PNG_ITXT_COMPRESSION_NONE;
        chunk.key = const_cast<char*>(name.c_str());
        chunk.text = const_cast<char*>(text.c_str());
        (isAscii(text) ? chunk.text_length : chunk.itxt_length) = text.size();
    }
    return chunks;
}

// Areas of one colour compress best unfiltered. Against libpng's defaults at its quickest level, half the
// time and three quarters of the size.
void chooseCompression(png_structp png) {
    png_set_filter(png, PNG_FILTER_TYPE_BASE, PNG_FILTER_NONE);
    png_set_compression_level(png, 3);
}

// An error of libpng jumps out of here: nothing below may own memory.
bool writeAll(png_structp png, png_infop info, const QImage& rgb, std::vector<png_text>& chunks) {
    if (setjmp(png_jmpbuf(png)) != 0) return false;
    png_set_IHDR(png, info, png_uint_32(rgb.width()), png_uint_32(rgb.height()), 8, PNG_COLOR_TYPE_RGB,
                 PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    png_set_pHYs(png, info, png_uint_32(rgb.dotsPerMeterX()), png_uint_32(rgb.dotsPerMeterY()),
                 PNG_RESOLUTION_METER);
    png_set_text(png, info, chunks.data(), int(chunks.size()));
    chooseCompression(png);
    png_write_info(png, info);
    for (int y = 0; y < rgb.height(); ++y) png_write_row(png, rgb.constScanLine(y));
    png_write_end(png, info);
    return true;
}

}  // namespace

bool writePng(const QImage& picture, const FileTags& tags, QIODevice& device) {
    const QImage rgb = picture.convertToFormat(QImage::Format_RGB888);
    if (rgb.isNull()) return false;
    std::vector<png_text> chunks = makeChunks(tags);
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, jumpOut, ignoreMessage);
    png_infop info = png != nullptr ? png_create_info_struct(png) : nullptr;
    bool written = false;
    if (info != nullptr) {
        png_set_write_fn(png, &device, writeBytes, ignoreFlush);
        written = writeAll(png, info, rgb, chunks);
    }
    png_destroy_write_struct(&png, &info);
    return written;
}

}  // namespace noonmark

extern "C" {
#include <libavcodec/avcodec.h>
#include <libavformat/avformat.h>
#include <libavutil/opt.h>
#include <libswscale/swscale.h>
}

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "app/report/movie/frame_colours.h"
#include "app/report/movie/movie_writer.h"

namespace noonmark {

namespace {

constexpr int leastSide = 64, mostSide = 4096;
constexpr double leastRate = 0.5, mostRate = 60;
constexpr int ticksPerSecond = 100;  // a GIF counts hundredths

bool isGif(const std::filesystem::path& file) { return file.extension() == ".gif"; }

Error cannotWrite(const std::string& file, const char* what) {
    return {std::string("The movie cannot be written: ") + what, file,
            "Check that the folder exists, is writable and has space"};
}

const AVCodec* findEncoder(bool gif) {
    if (gif) return avcodec_find_encoder(AV_CODEC_ID_GIF);
    const AVCodec* h264 = avcodec_find_encoder_by_name("libx264");
    return h264 != nullptr ? h264 : avcodec_find_encoder(AV_CODEC_ID_MPEG4);
}

}  // namespace

struct MovieWriter::Parts {
    struct FreeCodec {
        void operator()(AVCodecContext* context) const { avcodec_free_context(&context); }
    };
    struct FreeFrame {
        void operator()(AVFrame* frame) const { av_frame_free(&frame); }
    };
    struct FreePacket {
        void operator()(AVPacket* packet) const { av_packet_free(&packet); }
    };
    struct FreeScaler {
        void operator()(SwsContext* context) const { sws_freeContext(context); }
    };
    struct FreeFormat {
        void operator()(AVFormatContext* context) const {
            if (context->pb != nullptr) avio_closep(&context->pb);
            avformat_free_context(context);
        }
    };

    std::string file;
    MovieFormat format;
    bool gif = false;
    std::unique_ptr<AVFormatContext, FreeFormat> container;
    std::unique_ptr<AVCodecContext, FreeCodec> encoder;
    std::unique_ptr<AVFrame, FreeFrame> frame;
    std::unique_ptr<AVPacket, FreePacket> packet;
    std::unique_ptr<SwsContext, FreeScaler> scaler;
    AVStream* stream = nullptr;
    std::int64_t frames = 0;

    Result<void> open();
    Result<void> openEncoder(const AVCodec& codec);
    Result<void> encode(const AVFrame* next);
    void takePixels(const QImage& image);
    void takeIndices(const QImage& image);
};

Result<void> MovieWriter::Parts::openEncoder(const AVCodec& codec) {
    encoder.reset(avcodec_alloc_context3(&codec));
    encoder->width = format.size.width();
    encoder->height = format.size.height();
    encoder->pix_fmt = gif ? AV_PIX_FMT_PAL8 : AV_PIX_FMT_YUV420P;
    encoder->time_base = {1, ticksPerSecond};
    encoder->gop_size = 24;
    encoder->bit_rate = 8'000'000;  // of encoders without a quality
    // The colours of a screen, stated, so that players show them as they were painted.
    if (!gif) {
        encoder->color_range = AVCOL_RANGE_MPEG;
        encoder->colorspace = AVCOL_SPC_BT709;
        encoder->color_primaries = AVCOL_PRI_BT709;
        encoder->color_trc = AVCOL_TRC_BT709;
        av_opt_set(encoder->priv_data, "crf", "18", 0);
        av_opt_set(encoder->priv_data, "preset", "fast", 0);
    }
    if ((container->oformat->flags & AVFMT_GLOBALHEADER) != 0) encoder->flags |= AV_CODEC_FLAG_GLOBAL_HEADER;
    if (avcodec_open2(encoder.get(), &codec, nullptr) < 0)
        return tl::make_unexpected(cannotWrite(file, "the encoder refuses the size"));
    return {};
}

Result<void> MovieWriter::Parts::open() {
    AVFormatContext* made = nullptr;
    avformat_alloc_output_context2(&made, nullptr, gif ? "gif" : "mp4", file.c_str());
    container.reset(made);
    const AVCodec* codec = findEncoder(gif);
    if (!container || codec == nullptr)
        return tl::make_unexpected(cannotWrite(file, "the system has no encoder for it"));
    if (auto opened = openEncoder(*codec); !opened) return opened;
    stream = avformat_new_stream(container.get(), nullptr);
    stream->time_base = encoder->time_base;
    avcodec_parameters_from_context(stream->codecpar, encoder.get());
    frame.reset(av_frame_alloc());
    frame->format = encoder->pix_fmt;
    frame->width = encoder->width;
    frame->height = encoder->height;
    packet.reset(av_packet_alloc());
    if (av_frame_get_buffer(frame.get(), 0) < 0)
        return tl::make_unexpected(cannotWrite(file, "memory ran out"));
    // The index comes first, so that a browser plays before all is loaded.
    if (!gif) av_opt_set(container->priv_data, "movflags", "+faststart", 0);
    if (avio_open(&container->pb, file.c_str(), AVIO_FLAG_WRITE) < 0 ||
        avformat_write_header(container.get(), nullptr) < 0)
        return tl::make_unexpected(cannotWrite(file, "it cannot be created"));
    return {};
}

void MovieWriter::Parts::takePixels(const QImage& image) {
    const QImage pixels = image.convertToFormat(QImage::Format_RGB32);
    if (!scaler) {
        scaler.reset(sws_getContext(encoder->width, encoder->height, AV_PIX_FMT_BGRA, encoder->width,
                                    encoder->height, encoder->pix_fmt, SWS_BICUBIC, nullptr, nullptr,
                                    nullptr));
        sws_setColorspaceDetails(scaler.get(), sws_getCoefficients(SWS_CS_DEFAULT), 1,
                                 sws_getCoefficients(SWS_CS_ITU709), 0, 0, 1 << 16, 1 << 16);
    }
    const std::uint8_t* const lines[] = {pixels.constBits()};
    const int strides[] = {int(pixels.bytesPerLine())};
    sws_scale(scaler.get(), lines, strides, 0, encoder->height, frame->data, frame->linesize);
}

void MovieWriter::Parts::takeIndices(const QImage& image) {
    const QImage indices = reduceColours(image);
    for (int row = 0; row < indices.height(); ++row)
        std::memcpy(frame->data[0] + std::ptrdiff_t(row) * frame->linesize[0], indices.constScanLine(row),
                    std::size_t(indices.width()));
    std::uint32_t colours[256] = {};
    for (int i = 0; i < int(indices.colorCount()); ++i) colours[i] = indices.color(i);
    std::memcpy(frame->data[1], colours, sizeof colours);
}

// Null: the end.
Result<void> MovieWriter::Parts::encode(const AVFrame* next) {
    if (avcodec_send_frame(encoder.get(), next) < 0)
        return tl::make_unexpected(cannotWrite(file, "a frame was refused"));
    while (avcodec_receive_packet(encoder.get(), packet.get()) == 0) {
        if (packet->duration == 0) packet->duration = std::llround(ticksPerSecond / format.framesPerSecond);
        av_packet_rescale_ts(packet.get(), encoder->time_base, stream->time_base);
        packet->stream_index = stream->index;
        if (av_interleaved_write_frame(container.get(), packet.get()) < 0)
            return tl::make_unexpected(cannotWrite(file, "the disk may be full"));
    }
    return {};
}

MovieWriter::MovieWriter(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
MovieWriter::MovieWriter(MovieWriter&&) noexcept = default;
MovieWriter& MovieWriter::operator=(MovieWriter&&) noexcept = default;
MovieWriter::~MovieWriter() = default;

Result<void> validate(const MovieFormat& format) {
    const auto fits = [](int side) { return side >= leastSide && side <= mostSide && side % 2 == 0; };
    if (!fits(format.size.width()) || !fits(format.size.height()))
        return failure(
            fmt::format("The size {} x {} is not possible", format.size.width(), format.size.height()),
            "size", fmt::format("Give even numbers of {} to {}", leastSide, mostSide));
    if (format.framesPerSecond >= leastRate && format.framesPerSecond <= mostRate) return {};
    return failure("The number of frames per second is out of range", "fps",
                   fmt::format("Give {} to {}", leastRate, mostRate));
}

Result<MovieWriter> MovieWriter::create(const std::filesystem::path& file, const MovieFormat& format) {
    if (auto valid = validate(format); !valid) return tl::make_unexpected(valid.error());
    if (!isGif(file) && file.extension() != ".mp4")
        return failure("The name of a movie ends with .mp4 or .gif", file.string(), "Give such a name");
    av_log_set_level(AV_LOG_QUIET);
    auto parts = std::make_unique<Parts>();
    parts->file = file.string();
    parts->format = format;
    parts->gif = isGif(file);
    if (auto opened = parts->open(); !opened) return tl::make_unexpected(opened.error());
    return MovieWriter(std::move(parts));
}

Result<void> MovieWriter::add(const QImage& frame) {
    Parts& parts = *parts_;
    const QImage image =
        frame.size() == parts.format.size
            ? frame
            : frame.scaled(parts.format.size, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
    if (av_frame_make_writable(parts.frame.get()) < 0)
        return tl::make_unexpected(cannotWrite(parts.file, "memory ran out"));
    if (parts.gif)
        parts.takeIndices(image);
    else
        parts.takePixels(image);
    parts.frame->pts = std::llround(double(parts.frames++) * ticksPerSecond / parts.format.framesPerSecond);
    return parts.encode(parts.frame.get());
}

Result<void> MovieWriter::finish() {
    if (auto flushed = parts_->encode(nullptr); !flushed) return flushed;
    if (av_write_trailer(parts_->container.get()) >= 0 && avio_closep(&parts_->container->pb) >= 0) return {};
    return tl::make_unexpected(cannotWrite(parts_->file, "the disk may be full"));
}

}  // namespace noonmark

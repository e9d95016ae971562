extern "C" {
#include <libavcodec/avcodec.h>
#include <libavformat/avformat.h>
#include <libavutil/opt.h>
#include <libswscale/swscale.h>
}

#include <cmath>
#include <cstring>
#include <memory>
#include <string>

#include "app/report/movie/encoder/movie_encoder.h"

namespace noonmark {

namespace {

constexpr int ticksPerSecond = 100;  // a GIF counts hundredths
constexpr std::size_t paletteBytes = 256 * sizeof(std::uint32_t);

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

const AVCodec* findEncoder(bool gif) {
    if (gif) return avcodec_find_encoder(AV_CODEC_ID_GIF);
    const AVCodec* h264 = avcodec_find_encoder_by_name("libx264");
    return h264 != nullptr ? h264 : avcodec_find_encoder(AV_CODEC_ID_MPEG4);
}

class AvEncoder : public MovieEncoder {
public:
    AvEncoder(const char* file, const MovieTrack& track) : file_(file), track_(track) {}

    const char* open() {
        AVFormatContext* made = nullptr;
        avformat_alloc_output_context2(&made, nullptr, track_.gif ? "gif" : "mp4", file_.c_str());
        container_.reset(made);
        const AVCodec* codec = findEncoder(track_.gif);
        if (!container_ || codec == nullptr) return "the system has no encoder for it";
        if (!openCodec(*codec)) return "the encoder refuses the size";
        stream_ = avformat_new_stream(container_.get(), nullptr);
        stream_->time_base = codec_->time_base;
        avcodec_parameters_from_context(stream_->codecpar, codec_.get());
        if (!makeFrame()) return "memory ran out";
        // The index comes first, so that a browser plays before all is loaded.
        if (!track_.gif) av_opt_set(container_->priv_data, "movflags", "+faststart", 0);
        const bool begun = avio_open(&container_->pb, file_.c_str(), AVIO_FLAG_WRITE) >= 0 &&
                           avformat_write_header(container_.get(), nullptr) >= 0;
        return begun ? nullptr : "it cannot be created";
    }

    const char* addPixels(const std::uint8_t* pixels, int bytesPerRow) override {
        if (av_frame_make_writable(frame_.get()) < 0) return "memory ran out";
        if (!scaler_) makeScaler();
        sws_scale(scaler_.get(), &pixels, &bytesPerRow, 0, track_.height, frame_->data, frame_->linesize);
        return encodeFrame();
    }

    const char* addIndices(const std::uint8_t* indices, int bytesPerRow,
                           const std::uint32_t* colours) override {
        if (av_frame_make_writable(frame_.get()) < 0) return "memory ran out";
        for (std::ptrdiff_t row = 0; row < track_.height; ++row)
            std::memcpy(frame_->data[0] + row * frame_->linesize[0], indices + row * bytesPerRow,
                        std::size_t(track_.width));
        std::memcpy(frame_->data[1], colours, paletteBytes);
        return encodeFrame();
    }

    const char* finish() override {
        if (const char* problem = encode(nullptr)) return problem;
        const bool complete = av_write_trailer(container_.get()) >= 0 && avio_closep(&container_->pb) >= 0;
        return complete ? nullptr : "the disk may be full";
    }

private:
    bool openCodec(const AVCodec& codec) {
        codec_.reset(avcodec_alloc_context3(&codec));
        codec_->width = track_.width;
        codec_->height = track_.height;
        codec_->pix_fmt = track_.gif ? AV_PIX_FMT_PAL8 : AV_PIX_FMT_YUV420P;
        codec_->time_base = {1, ticksPerSecond};
        codec_->gop_size = 24;
        codec_->bit_rate = 8'000'000;  // of encoders without a quality
        if (!track_.gif) setColours();
        if ((container_->oformat->flags & AVFMT_GLOBALHEADER) != 0)
            codec_->flags |= AV_CODEC_FLAG_GLOBAL_HEADER;
        return avcodec_open2(codec_.get(), &codec, nullptr) >= 0;
    }

    // The colours of a screen, stated, so that players show them as they were painted.
    void setColours() {
        codec_->color_range = AVCOL_RANGE_MPEG;
        codec_->colorspace = AVCOL_SPC_BT709;
        codec_->color_primaries = AVCOL_PRI_BT709;
        codec_->color_trc = AVCOL_TRC_BT709;
        av_opt_set(codec_->priv_data, "crf", "18", 0);
        av_opt_set(codec_->priv_data, "preset", "fast", 0);
    }

    bool makeFrame() {
        frame_.reset(av_frame_alloc());
        frame_->format = codec_->pix_fmt;
        frame_->width = track_.width;
        frame_->height = track_.height;
        packet_.reset(av_packet_alloc());
        return av_frame_get_buffer(frame_.get(), 0) >= 0;
    }

    void makeScaler() {
        scaler_.reset(sws_getContext(track_.width, track_.height, AV_PIX_FMT_BGRA, track_.width,
                                     track_.height, codec_->pix_fmt, SWS_BICUBIC, nullptr, nullptr, nullptr));
        sws_setColorspaceDetails(scaler_.get(), sws_getCoefficients(SWS_CS_DEFAULT), 1,
                                 sws_getCoefficients(SWS_CS_ITU709), 0, 0, 1 << 16, 1 << 16);
    }

    const char* encodeFrame() {
        frame_->pts = std::llround(double(frames_++) * ticksPerSecond / track_.framesPerSecond);
        return encode(frame_.get());
    }

    // Null: the end.
    const char* encode(const AVFrame* next) {
        if (avcodec_send_frame(codec_.get(), next) < 0) return "a frame was refused";
        while (avcodec_receive_packet(codec_.get(), packet_.get()) == 0) {
            if (packet_->duration == 0)
                packet_->duration = std::llround(ticksPerSecond / track_.framesPerSecond);
            av_packet_rescale_ts(packet_.get(), codec_->time_base, stream_->time_base);
            packet_->stream_index = stream_->index;
            if (av_interleaved_write_frame(container_.get(), packet_.get()) < 0)
                return "the disk may be full";
        }
        return nullptr;
    }

    std::string file_;
    MovieTrack track_;
    std::unique_ptr<AVFormatContext, FreeFormat> container_;
    std::unique_ptr<AVCodecContext, FreeCodec> codec_;
    std::unique_ptr<AVFrame, FreeFrame> frame_;
    std::unique_ptr<AVPacket, FreePacket> packet_;
    std::unique_ptr<SwsContext, FreeScaler> scaler_;
    AVStream* stream_ = nullptr;  // of container_
    std::int64_t frames_ = 0;
};

}  // namespace

}  // namespace noonmark

extern "C" __attribute__((visibility("default"))) noonmark::MadeMovieEncoder noonmarkMakeMovieEncoder(
    const char* file, const noonmark::MovieTrack& track) {
    av_log_set_level(AV_LOG_QUIET);
    auto encoder = std::make_unique<noonmark::AvEncoder>(file, track);
    if (const char* problem = encoder->open()) return {nullptr, problem};
    return {encoder.release(), nullptr};
}

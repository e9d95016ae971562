#include <zlib.h>

#include <array>
#include <memory>

#include "core/io/archives/unpack_archive.h"

namespace noonmark {

namespace {

struct CloseGzip {
    void operator()(gzFile file) const { gzclose(file); }
};

// "city.gml" of "city.gml.gz".
std::string nameWithout(const std::filesystem::path& file) {
    const std::string ending = file.extension().string();
    return ending == ".gz" || ending == ".GZ" ? file.stem().string() : file.filename().string() + ".unpacked";
}

}  // namespace

Result<void> unpackGzip(const std::filesystem::path& file, const std::filesystem::path& folder,
                        UnpackBudget& budget, const std::stop_token& stop) {
    constexpr const char* advice = "Pack or download it again";
    const std::unique_ptr<gzFile_s, CloseGzip> packed(gzopen(file.c_str(), "rb"));
    auto unpacked = UnpackedFile::create(folder, nameWithout(file), budget);
    if (!unpacked) return tl::make_unexpected(unpacked.error());
    if (!packed) return failure("The archive cannot be opened", {}, advice);
    std::array<char, 1U << 16U> bytes{};
    for (;;) {
        if (stop.stop_requested()) return cancelled();
        const int count = gzread(packed.get(), bytes.data(), unsigned(bytes.size()));
        int problem = Z_OK;
        gzerror(packed.get(), &problem);
        if (count < 0 || problem != Z_OK) return failure("The archive is damaged or cut off", {}, advice);
        if (count == 0) return unpacked->close();
        if (auto written = unpacked->write({bytes.data(), std::size_t(count)}); !written) return written;
    }
}

}  // namespace noonmark

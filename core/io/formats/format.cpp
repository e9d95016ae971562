#include "core/io/formats/format.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <algorithm>
#include <cctype>
#include <fstream>
#include <nlohmann/json.hpp>

namespace noonmark {

namespace {

JsonKind kindOfType(std::string_view type) {
    if (type == "CityJSON" || type == "CityJSONFeature") return JsonKind::cityJson;
    if (type == "FeatureCollection" || type == "Feature" || type == "GeometryCollection")
        return JsonKind::geoJson;
    if (type.ends_with("Polygon") || type.ends_with("Point") || type.ends_with("LineString"))
        return JsonKind::geoJson;
    return JsonKind::other;
}

JsonKind kindOfKey(std::string_view key) {
    if (key == "CityObjects") return JsonKind::cityJson;
    if (key == "features") return JsonKind::geoJson;
    if (key == "asset") return JsonKind::gltf;
    return JsonKind::other;
}

// Inspects only the keys of the outermost object; every callback returns whether to read on.
class KindFinder final : public nlohmann::json_sax<nlohmann::json> {
public:
    JsonKind kind = JsonKind::other;

    bool null() override { return true; }
    bool boolean(bool) override { return true; }
    bool number_integer(number_integer_t) override { return true; }
    bool number_unsigned(number_unsigned_t) override { return true; }
    bool number_float(number_float_t, const string_t&) override { return true; }
    bool binary(binary_t&) override { return true; }
    bool string(string_t& text) override {
        if (depth_ == 1 && key_ == "type") kind = kindOfType(text);
        return undecided();
    }
    bool key(string_t& text) override {
        if (depth_ != 1) return true;
        key_ = text;
        kind = kindOfKey(key_);
        return undecided();
    }
    bool start_object(std::size_t) override { return enter(); }
    bool end_object() override { return leave(); }
    bool start_array(std::size_t) override { return enter(); }
    bool end_array() override { return leave(); }
    bool parse_error(std::size_t, const std::string&, const nlohmann::detail::exception&) override {
        return false;
    }

private:
    [[nodiscard]] bool undecided() const { return kind == JsonKind::other; }
    bool enter() {
        ++depth_;
        return true;
    }
    bool leave() {
        --depth_;
        return true;
    }
    int depth_ = 0;
    std::string key_;
};

}  // namespace

JsonKind detectJsonKind(std::istream& stream) {
    KindFinder finder;
    nlohmann::json::sax_parse(stream, &finder, nlohmann::json::input_format_t::json, false);
    return finder.kind;
}

namespace {

bool isMarked(const FileHead& head, const Mark& mark) {
    const std::string_view text = head.text();
    return text.starts_with(mark.begins) && text.find(mark.contains) != text.npos &&
           (mark.ending.empty() || head.ending == mark.ending);
}

bool isOf(const FileHead& head, const Format& format) {
    return std::ranges::any_of(format.marks, [&](const Mark& mark) { return isMarked(head, mark); }) ||
           (format.begins != nullptr && format.begins(head)) ||
           (format.json != JsonKind::other && head.json == format.json);
}

bool holds(const std::vector<std::string_view>& endings, std::string_view ending) {
    return std::ranges::find(endings, ending) != endings.end();
}

std::string endingOf(const std::filesystem::path& file) {
    std::string ending = file.extension().string();
    for (char& letter : ending) letter = char(std::tolower(static_cast<unsigned char>(letter)));
    return ending;
}

template <class Condition>
const Format* findFirst(Formats formats, const Condition& condition) {
    const auto found = std::ranges::find_if(formats, condition);
    return found == formats.end() ? nullptr : &*found;
}

/// What `list` says of the formats of these kinds, each once.
template <class List>
std::vector<std::string_view> collect(std::initializer_list<FileKind> kinds, Formats formats,
                                      const List& list) {
    std::vector<std::string_view> all;
    for (const FileKind kind : kinds)
        for (const Format& format : formats)
            if (format.isRead() && format.reader.kind == kind)
                for (const std::string_view one : list(format))
                    if (!holds(all, one)) all.push_back(one);
    return all;
}

// Readers take endings in capitals, too, where a file system tells them apart.
std::filesystem::path companionOf(const std::filesystem::path& file, std::string_view ending) {
    std::string capitals(ending);
    for (char& letter : capitals) letter = char(std::toupper(static_cast<unsigned char>(letter)));
    const auto small = std::filesystem::path(file).replace_extension(ending);
    const auto large = std::filesystem::path(file).replace_extension(capitals);
    std::error_code error;
    return !std::filesystem::exists(small, error) && std::filesystem::exists(large, error) ? large : small;
}

}  // namespace

std::string_view FileHead::text() const {
    std::string_view text = bytes;
    if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
    text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
    return text;
}

FileHead readFileHead(const std::filesystem::path& file) {
    constexpr std::size_t headBytes = 8192;
    FileHead head{.bytes = std::string(headBytes, '\0'), .ending = endingOf(file)};
    std::ifstream stream(file, std::ios::binary);
    stream.read(head.bytes.data(), std::streamsize(headBytes));
    head.bytes.resize(std::size_t(std::max<std::streamsize>(0, stream.gcount())));
    std::error_code error;
    const std::uintmax_t size = std::filesystem::file_size(file, error);
    head.size = error ? head.bytes.size() : size;
    return head;
}

const Format* findReadFormat(const FileHead& head, Formats formats) {
    return findFirst(formats, [&](const Format& format) { return format.isRead() && isOf(head, format); });
}

const Format* findForeignFormat(const FileHead& head, Formats formats) {
    const auto isHeadless = [&](const Format& format) { return holds(format.headless, head.ending); };
    if (head.bytes.empty() || std::ranges::any_of(formats, isHeadless)) return nullptr;
    return findFirst(formats, [&](const Format& format) { return !format.isRead() && isOf(head, format); });
}

Result<void> refuseForeignFormat(const std::filesystem::path& file, Formats formats) {
    std::error_code error;
    if (!std::filesystem::is_regular_file(file, error)) return {};
    const Format* format = findForeignFormat(readFileHead(file), formats);
    if (format == nullptr) return {};
    return unsupported(fmt::format("This is {}, which is not read", format->name), file.string(),
                       std::string(format->instead));
}

const Format* findByDriver(std::string_view driver, FileKind kind, Formats formats) {
    return findFirst(formats, [&](const Format& format) {
        return format.isRead() && format.reader.kind == kind && format.driver == driver;
    });
}

const Format* findByEnding(const std::filesystem::path& file, FileKind kind, Formats formats) {
    const std::string ending = endingOf(file);
    return findFirst(formats, [&](const Format& format) {
        return format.isRead() && format.reader.kind == kind && holds(format.endings, ending);
    });
}

std::vector<std::filesystem::path> listCompanionFiles(const std::filesystem::path& file, Formats formats) {
    std::vector<std::filesystem::path> companions;
    const std::string ending = endingOf(file);
    const Format* format =
        findFirst(formats, [&](const Format& one) { return one.isRead() && holds(one.endings, ending); });
    if (format == nullptr) return companions;
    for (const std::string_view companion : format->companions)
        companions.push_back(companionOf(file, companion));
    return companions;
}

std::string listNames(std::initializer_list<FileKind> kinds, Formats formats) {
    const auto names = collect(kinds, formats, [](const Format& format) { return std::vector{format.name}; });
    return fmt::format("{}", fmt::join(names, ", "));
}

std::vector<std::string_view> listEndings(std::initializer_list<FileKind> kinds, Formats formats) {
    return collect(kinds, formats, [](const Format& format) { return format.endings; });
}

}  // namespace noonmark

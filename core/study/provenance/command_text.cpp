#include "core/study/provenance/command_text.h"

#include <fmt/format.h>
#include <algorithm>
#include <cctype>
#include <limits>
#include <nlohmann/json.hpp>
#include <string_view>

#include "core/base/safe_text.h"
#include "core/describe/field_values.h"
#include "core/io/settings/read_settings.h"
#include "core/study/study_fields.h"
#include "core/study/text/error_text.h"
#include "core/study/text/height_facts_text.h"
#include "core/sun/period_fields.h"

namespace noonmark {

namespace {

// "--region=-x": a value that looks like an option is joined to its option by =; negative numbers need not
// be.
bool looksLikeOption(const std::string& value) {
    return value.size() > 1 && value[0] == '-' && std::isdigit(static_cast<unsigned char>(value[1])) == 0;
}

// Splits one command line, letter by letter.
class WordSplitter {
public:
    explicit WordSplitter(const std::string& command) : rest_(command) {}

    Result<std::vector<std::string>> split() {
        while (!rest_.empty()) {
            const char letter = take();
            if (letter == '\'' || letter == '"') {
                if (!takeQuoted(letter)) return failure("A quote does not end", "command", {});
            } else if (letter == '\\') {
                takeEscaped();
            } else if (letter == ' ' || letter == '\t' || letter == '\n') {
                endWord();
            } else if (std::string_view("$`|;&<>()*?#").find(letter) != std::string_view::npos) {
                return failure(fmt::format("'{}' is more than a word to a shell", letter), "command", {});
            } else {
                add(letter);
            }
        }
        endWord();
        return words_;
    }

private:
    char take() {
        const char letter = rest_.front();
        rest_.remove_prefix(1);
        return letter;
    }
    void add(char letter) {
        word_ += letter;
        inWord_ = true;
    }
    bool takeQuoted(char quote) {
        inWord_ = true;  // '' is an empty word
        while (!rest_.empty()) {
            char letter = take();
            if (letter == quote) return true;
            if (quote == '"' && letter == '\\' && !rest_.empty()) letter = take();
            add(letter);
        }
        return false;
    }
    void takeEscaped() {
        if (rest_.empty()) return;
        const char letter = take();
        if (letter != '\n') add(letter);
    }
    void endWord() {
        if (inWord_) words_.push_back(word_);
        word_.clear();
        inWord_ = false;
    }

    std::string_view rest_;
    std::vector<std::string> words_;
    std::string word_;
    bool inWord_ = false;
};

}  // namespace

void CommandLineText::file(const std::string& name) {
    pieces_.push_back(quoteForShell(name.starts_with('-') ? "./" + name : name));
}

void CommandLineText::option(const char* name, const std::string& value) {
    pieces_.push_back(fmt::format("{}{}{}", name, looksLikeOption(value) ? "=" : " ", quoteForShell(value)));
}

void CommandLineText::option(const CommandOption& option) {
    if (option.values.size() == 1) return this->option(option.name.c_str(), option.values.front());
    std::string piece = option.name;
    for (const std::string& value : option.values) piece += ' ' + quoteForShell(value);
    pieces_.push_back(std::move(piece));
}

std::string CommandLineText::wrapped(std::size_t width) const {
    std::string text;
    std::size_t used = 0;
    for (const std::string& piece : pieces_) {
        const bool breaks = used > 0 && used + 1 + piece.size() + 2 > width;
        if (used > 0) text += breaks ? " \\\n    " : " ";
        used = (breaks ? 4 : used + (used > 0 ? 1 : 0)) + piece.size();
        text += piece;
    }
    return text;
}

std::string extendCommand(const std::string& command, const std::vector<CommandOption>& options,
                          std::size_t width) {
    CommandLineText words(command);
    for (const CommandOption& option : options) words.option(option);
    return words.wrapped(width);
}

std::string extendRepeat(std::string record, const std::vector<CommandOption>& options) {
    if (options.empty()) return record;
    auto json = nlohmann::ordered_json::parse(record, nullptr, false);
    if (!json.is_object() || !json.contains("repeat") || !json["repeat"].is_string()) return record;
    json["repeat"] =
        extendCommand(json["repeat"].get<std::string>(), options, std::numeric_limits<std::size_t>::max());
    return toJsonText(json);
}

Result<std::vector<std::string>> splitCommand(const std::string& command) {
    return WordSplitter(command).split();
}

namespace {

/// Writes commands that read the same files in the same way.
class StepWriter {
public:
    StepWriter(const std::vector<std::string>& files, const ReadSettings& settings)
        : files_(files), options_(listOptions(readSettingsFields().of(settings))) {}

    [[nodiscard]] std::string write(const char* program, const std::string& more,
                                    const std::string& file = {}) const {
        CommandLineText words(program);
        for (const std::string& name : files_) words.file(name);
        if (!file.empty()) words.file(file);
        for (const CommandOption& option : options_) words.option(option);
        const std::string command = words.wrapped(std::numeric_limits<std::size_t>::max());
        return more.empty() ? command : command + " " + more;
    }

    [[nodiscard]] bool hasOptions() const { return !options_.empty(); }

private:
    const std::vector<std::string>& files_;
    std::vector<CommandOption> options_;
};

std::string_view nameFlag(std::span<const Field> rows, std::string_view key) {
    return fieldWithKey(rows, key).flag;
}

// 500 m around the middle of the buildings, or all of them where that is less.
std::string firstRegion(const City& city) {
    constexpr double halfM = 250;
    const Box2 box = bounds(city);
    const glm::dvec2 middle = (glm::dvec2(box.low) + glm::dvec2(box.high)) / 2.0;
    const glm::dvec2 half = glm::min(glm::dvec2(box.high) - middle, glm::dvec2(halfM));
    const LonLat low = city.frame.lonLatFromLocal(middle - half);
    const LonLat high = city.frame.lonLatFromLocal(middle + half);
    return fmt::format("{:.5f},{:.5f},{:.5f},{:.5f}", low.lonDeg, low.latDeg, high.lonDeg, high.latDeg);
}

}  // namespace

std::vector<NextStep> listNextSteps(const CityRead& read, const std::vector<std::string>& files,
                                    const ReadSettings& settings) {
    if (read.city.buildings.empty()) return {};
    const StepWriter writer(files, settings);
    std::vector<NextStep> steps;
    const auto assumed = makeAssumedHeadline(countHeights(read.city));
    if (assumed && !read.heights.unknown.empty()) {
        const std::string options = selectingOptions(read.heights.unknown.front());
        steps.push_back(
            {*assumed, writer.write("noonmark-cli info", options.substr(0, options.find(" or ")))});
    }
    const bool showsRoofs = read.city.terrain && read.city.terrain->source.underBuildings > 0;
    if (assumed && showsRoofs && !settings.heightsFromSurface)
        steps.push_back({"heights are assumed that the surface model shows",
                         writer.write("noonmark-cli info", readOption("heights_from_surface"))});
    if (!read.city.terrain)
        steps.push_back({"the ground is flat, since there is no terrain",
                         writer.write("noonmark-cli info", {}, "TERRAIN.tif")});
    steps.push_back(
        {"a day around its middle",
         writer.write(
             "noonmark-cli study",
             fmt::format("{} 2026-06-21 {} sunrise..sunset {}={} {} first-study",
                         nameFlag(periodFields().rows(), "start"), nameFlag(periodFields().rows(), "window"),
                         nameFlag(studyFields().rows(), "region"), firstRegion(read.city), flags::out))});
    steps.push_back(writer.hasOptions()
                        ? NextStep{"a project, which opens in the window",
                                   writer.write("noonmark-cli project new city.noonmark.gpkg", {})}
                        : NextStep{"to see it in the window", writer.write("noonmark", {})});
    constexpr std::size_t maximum = 3;
    steps.resize(std::min(steps.size(), maximum));
    return steps;
}

}  // namespace noonmark

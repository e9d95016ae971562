#include "core/study/provenance/command_words.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <limits>
#include <nlohmann/json.hpp>
#include <string_view>

#include "core/base/escaped_text.h"
#include "core/study/text/error_words.h"

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

void CommandWords::file(const std::string& name) {
    pieces_.push_back(quoteForShell(name.starts_with('-') ? "./" + name : name));
}

void CommandWords::option(const char* name, const std::string& value) {
    pieces_.push_back(fmt::format("{}{}{}", name, looksLikeOption(value) ? "=" : " ", quoteForShell(value)));
}

void CommandWords::option(const CommandOption& option) {
    if (option.values.size() == 1) return this->option(option.name.c_str(), option.values.front());
    std::string piece = option.name;
    for (const std::string& value : option.values) piece += ' ' + quoteForShell(value);
    pieces_.push_back(std::move(piece));
}

std::string CommandWords::wrapped(std::size_t width) const {
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
    CommandWords words(command);
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

}  // namespace noonmark

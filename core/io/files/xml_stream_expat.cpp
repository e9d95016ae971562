#include <expat.h>
#include <fmt/format.h>

#include <exception>
#include <memory>
#include <optional>
#include <string>

#include "core/describe/text.h"
#include "core/io/files/plain_file.h"
#include "core/io/files/xml_stream.h"

namespace noonmark {

namespace {

constexpr int maxNesting = 200;
constexpr std::size_t maxTagBytes = std::size_t(16) << 20U;
constexpr std::size_t maxTextBytes = std::size_t(64) << 20U;
constexpr const char* damagedAdvice = "Export or download it again";

std::string_view withoutPrefix(std::string_view name) {
    const std::size_t colon = name.rfind(':');
    return colon == name.npos ? name : name.substr(colon + 1);
}

/// Passes what Expat finds to a listener, and keeps what ends the reading: nothing may be thrown through it.
class XmlParse {
public:
    XmlParse(std::string file, XmlListener& listener)
        : parser_(XML_ParserCreate(nullptr)), file_(std::move(file)), listener_(listener) {
        XML_SetUserData(parser_.get(), this);
        XML_SetElementHandler(parser_.get(), begin, end);
        XML_SetCharacterDataHandler(parser_.get(), addText);
        XML_SetEntityDeclHandler(parser_.get(), refuseEntity);
    }

    /// False at the end and after an error.
    bool feed(StoppableStream& stream) {
        constexpr int pieceBytes = 1 << 18;
        void* piece = XML_GetBuffer(parser_.get(), pieceBytes);
        if (piece == nullptr) return fail(limitReached("There is not enough memory for the file"));
        stream.read(static_cast<char*>(piece), pieceBytes);
        const auto count = std::size_t(stream.gcount());
        fed_ += count;
        const bool isLast = count == 0;
        if (XML_ParseBuffer(parser_.get(), int(count), isLast ? 1 : 0) == XML_STATUS_ERROR)
            return error_ || thrown_ ? false : fail(damaged());
        // Negative where Expat waits for more of a long tag before it looks at it again, as it does since 2.6
        // and its backports.
        const XML_Index read = XML_GetCurrentByteIndex(parser_.get());
        if (read >= 0) read_ = std::size_t(read);
        if (fed_ - read_ > maxTagBytes)
            return fail(limitReached("A tag or comment of the file has more than 16 MiB"));
        return !isLast;
    }

    Result<void> takeOutcome() {
        if (thrown_) std::rethrow_exception(thrown_);
        if (error_) return tl::make_unexpected(*std::move(error_));
        return {};
    }

private:
    struct Free {
        void operator()(XML_Parser parser) const { XML_ParserFree(parser); }
    };

    tl::unexpected<Error> damaged() const {
        const char* why = XML_ErrorString(XML_GetErrorCode(parser_.get()));
        return failure(fmt::format("The file is not valid XML ({})", why == nullptr ? "damaged" : why), {},
                       damagedAdvice);
    }

    bool fail(tl::unexpected<Error> error) {
        if (error_) return false;
        error_ = std::move(error.value());
        const std::string line = fmt::format("{}: line {}", file_, XML_GetCurrentLineNumber(parser_.get()));
        error_->where = error_->where.empty() ? line : line + ", " + error_->where;
        XML_StopParser(parser_.get(), XML_FALSE);
        return false;
    }

    template <class Work>
    void run(const Work& work) try {
        if (error_ || thrown_) return;
        if (Result<void> done = work(); !done) fail(tl::make_unexpected(std::move(done.error())));
    } catch (...) {
        thrown_ = std::current_exception();
        XML_StopParser(parser_.get(), XML_FALSE);
    }

    static void begin(void* self, const char* name, const char** attributes) {
        auto& parse = *static_cast<XmlParse*>(self);
        parse.run([&]() -> Result<void> {
            parse.text_.clear();
            if (++parse.nesting_ > maxNesting)
                return limitReached(fmt::format("Elements are nested more than {} deep", maxNesting));
            return parse.listener_.begin({withoutPrefix(name), attributes});
        });
    }

    static void end(void* self, const char* name) {
        auto& parse = *static_cast<XmlParse*>(self);
        parse.run([&]() -> Result<void> {
            --parse.nesting_;
            const Result<void> done = parse.listener_.end(withoutPrefix(name), parse.text_);
            parse.text_.clear();
            return done;
        });
    }

    static void addText(void* self, const char* text, int count) {
        auto& parse = *static_cast<XmlParse*>(self);
        parse.run([&]() -> Result<void> {
            if (!parse.listener_.wantsText()) return {};
            if (parse.text_.size() + std::size_t(count) > maxTextBytes)
                return limitReached("A text of the file has more than 64 MiB");
            parse.text_.append(text, std::size_t(count));
            return {};
        });
    }

    static void refuseEntity(void* self, const char* name, int, const char*, int, const char*, const char*,
                             const char*, const char*) {
        auto& parse = *static_cast<XmlParse*>(self);
        parse.run([&]() -> Result<void> {
            return failure(fmt::format("The file declares an entity (\"{}\"), which is refused", name), {},
                           "Remove its DOCTYPE, and write the values themselves");
        });
    }

    std::unique_ptr<XML_ParserStruct, Free> parser_;
    std::string file_;
    XmlListener& listener_;
    std::string text_;
    std::size_t fed_ = 0;
    std::size_t read_ = 0;  ///< where Expat stands
    int nesting_ = 0;
    std::optional<Error> error_;
    std::exception_ptr thrown_;
};

}  // namespace

std::string_view XmlElement::attribute(std::string_view wanted) const {
    for (const char* const* at = attributes; *at != nullptr; at += 2)
        if (withoutPrefix(*at) == wanted) return at[1];
    return {};
}

Result<void> streamXml(const std::filesystem::path& file, XmlListener& listener, Progress& progress,
                       const std::stop_token& stop) {
    StoppableStream stream(file, stop);
    if (!stream.opened())
        return failure("The file cannot be opened", file.string(),
                       "Check that it is there and that you may read it");
    XmlParse parse(file.filename().string(), listener);
    while (!stop.stop_requested() && parse.feed(stream))
        progress.report(stream.share(), NM_TEXT("reading the city"));
    if (stop.stop_requested()) return cancelled();
    return parse.takeOutcome();
}

}  // namespace noonmark

#pragma once

#include <filesystem>
#include <stop_token>
#include <string_view>

#include "core/base/progress.h"
#include "core/base/result.h"

namespace noonmark {

/// An element of XML as it begins. Names are without prefix: "bldg:Building" is "Building". Views are valid
/// during the call only.
struct XmlElement {
    std::string_view name;
    const char* const* attributes;  ///< name, value, name, value, ..., null

    /// The value of the attribute of this name, without prefix; empty if there is none.
    [[nodiscard]] std::string_view attribute(std::string_view wanted) const;
};

/// Takes the elements of a file in their order. An Error ends the reading; streamXml() adds file and line.
class XmlListener {
public:
    virtual ~XmlListener() = default;
    virtual Result<void> begin(const XmlElement& element) = 0;
    /// `text`: the text between this end and the begin or end before it; all text of an element without
    /// others inside.
    virtual Result<void> end(std::string_view name, std::string_view text) = 0;
    /// Whether the text after the element that began or ended last is wanted; else end() gets none.
    [[nodiscard]] virtual bool wantsText() const = 0;
};

/// Reads XML in pieces: never more than one element is held. Nothing that the file names is opened. Error:
/// not XML, or cut off; it declares entities, which could grow without end; elements nested more than 200
/// deep, a tag or comment over 16 MiB, a text over 64 MiB; the listener's; cancelled(). Some 100 MB/s.
/// Backend: xml_stream_expat.cpp.
Result<void> streamXml(const std::filesystem::path& file, XmlListener& listener, Progress& progress,
                       const std::stop_token& stop);

}  // namespace noonmark

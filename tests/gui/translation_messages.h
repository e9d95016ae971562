#pragma once

#include <gtest/gtest.h>

#include <QApplication>
#include <QFile>
#include <QRegularExpression>
#include <QXmlStreamReader>
#include <string>
#include <vector>

#include "app/language/language.h"
#include "tests/shared/shared_data.h"

namespace noonmark::test {

inline constexpr Language translatedLanguages[] = {Language::german, Language::spanish, Language::japanese};

struct Message {
    QString context, source;
    QStringList texts;  ///< one or, of a plural text, one per form
    bool plural = false, finished = false;
};

inline std::string codeOf(Language language) {
    for (const LanguageEntry& entry : languages)
        if (entry.language == language) return entry.code;
    return {};
}

/// The messages of a .ts file. Fails the test where the XML is not well formed.
inline std::vector<Message> readMessages(Language language) {
    QFile file(QString::fromStdString(
        tests::sourceFile("resources/translations/noonmark_" + codeOf(language) + ".ts").string()));
    EXPECT_TRUE(file.open(QIODevice::ReadOnly)) << file.fileName().toStdString();
    QXmlStreamReader xml(&file);
    std::vector<Message> messages;
    QString context;
    while (!xml.atEnd()) {
        if (xml.readNext() != QXmlStreamReader::StartElement) continue;
        if (xml.name() == u"name") context = xml.readElementText();
        if (xml.name() == u"message")
            messages.push_back({context, {}, {}, xml.attributes().hasAttribute(QStringLiteral("numerus"))});
        if (xml.name() == u"source") messages.back().source = xml.readElementText();
        if (xml.name() == u"numerusform") messages.back().texts << xml.readElementText();
        if (xml.name() != u"translation") continue;
        messages.back().finished = !xml.attributes().hasAttribute(QStringLiteral("type"));
        if (!messages.back().plural) messages.back().texts << xml.readElementText();
    }
    EXPECT_FALSE(xml.hasError()) << xml.errorString().toStdString();
    return messages;
}

inline QStringList placeholdersOf(const QString& text) {
    static const QRegularExpression placeholder(QStringLiteral("%(L?\\d|n)"));
    QStringList found;
    for (auto at = placeholder.globalMatch(text); at.hasNext();) found << at.next().captured();
    found.sort();
    return found;
}

inline QString spacesAround(const QString& text) {
    static const QRegularExpression start(QStringLiteral("^ *")), end(QStringLiteral(" *$"));
    return start.match(text).captured() + QLatin1Char('|') + end.match(text).captured();
}

/// Placeholders, filters of a file dialog and outer spaces are those of the source.
inline void expectSameParts(const QString& text, const Message& message, const std::string& language) {
    const std::string where = language + ": " + message.source.toStdString();
    EXPECT_FALSE(text.isEmpty()) << where;
    EXPECT_EQ(placeholdersOf(text), placeholdersOf(message.source)) << where;
    EXPECT_EQ(text.count(QStringLiteral(";;")), message.source.count(QStringLiteral(";;")))
        << where << ": filters of a file dialog";
    EXPECT_EQ(spacesAround(text), spacesAround(message.source)) << where;
}

/// Restores English, which other tests expect.
struct Languages : ::testing::Test {
    void use(Language language) { applyLanguage(language, *qApp); }
    ~Languages() override { use(Language::english); }
};

}  // namespace noonmark::test

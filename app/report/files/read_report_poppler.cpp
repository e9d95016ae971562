#include <poppler-qt6.h>

#include <QFile>
#include <algorithm>
#include <array>
#include <memory>

#include "app/report/files/read_report.h"
#include "core/io/files/plain_file.h"
#include "core/study/verification/result_record.h"

namespace noonmark {

namespace {

constexpr std::array recordNames{"study.json", "impact.json", "score.json", "review.json"};
constexpr int mostPages = 10'000;

Result<QByteArray> readBytes(const std::filesystem::path& path) {
    if (auto plain = checkPlainFile(path); !plain) return tl::make_unexpected(plain.error());
    QFile file(QString::fromStdString(path.string()));
    if (!file.open(QIODevice::ReadOnly))
        return failure("The file cannot be read", path.string(), "Check its permissions");
    if (std::uintmax_t(file.size()) > mostBytesOfRecord)
        return failure("The file is larger than any report", path.string(), {});
    return file.readAll();
}

Result<std::unique_ptr<Poppler::Document>> openPdf(const QByteArray& bytes,
                                                   const std::filesystem::path& path) {
    auto document = Poppler::Document::loadFromData(bytes);
    if (!document || document->isLocked() || document->numPages() > mostPages)
        return failure("The PDF is damaged, locked or no report", path.string(),
                       "Use the file as Noonmark wrote it");
    return document;
}

// In reading order, column by column, so that a line more in one column moves no word of the next.
std::string printedWords(const Poppler::Document& document) {
    QString words;
    for (int index = 0; index < document.numPages(); ++index)
        if (const auto page = document.page(index))
            for (const auto& box : page->textList()) words += box->text() + QLatin1Char(' ');
    return words.toStdString();
}

bool isRecordName(const QString& name) {
    return std::ranges::any_of(recordNames, [&](const char* known) { return name == QLatin1String(known); });
}

}  // namespace

Result<FiledReport> readReport(const std::filesystem::path& path) {
    const auto bytes = readBytes(path);
    if (!bytes) return tl::make_unexpected(bytes.error());
    if (!bytes->startsWith("%PDF"))
        return FiledReport{path.filename().string(), bytes->toStdString(), {}, false};
    const auto document = openPdf(*bytes, path);
    if (!document) return tl::make_unexpected(document.error());
    for (Poppler::EmbeddedFile* attached : (*document)->embeddedFiles())
        if (attached->isValid() && isRecordName(attached->name()))
            return FiledReport{attached->name().toStdString(), attached->data().toStdString(),
                               printedWords(**document), !(*document)->outline().isEmpty()};
    return failure("The PDF has no record of its result attached", path.string(),
                   "Give the study.json, impact.json, score.json or review.json that was written beside it");
}

Result<std::string> readPrintedWords(const std::filesystem::path& path) {
    const auto bytes = readBytes(path);
    if (!bytes) return tl::make_unexpected(bytes.error());
    const auto document = openPdf(*bytes, path);
    if (!document) return tl::make_unexpected(document.error());
    return printedWords(**document);
}

}  // namespace noonmark

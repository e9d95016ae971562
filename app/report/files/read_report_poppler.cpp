#include <poppler-qt6.h>

#include <QFile>
#include <QImage>
#include <QVariant>
#include <algorithm>
#include <cmath>
#include <memory>

#include "app/report/files/read_report.h"
#include "core/io/files/plain_file.h"
#include "core/study/verification/result_record.h"

Q_DECLARE_METATYPE(const std::stop_token*)

namespace noonmark {

namespace {

constexpr int maxPagesOfReport = 10'000;

Result<QByteArray> readBytes(const std::filesystem::path& path) {
    if (auto plain = checkPlainFile(path); !plain) return tl::make_unexpected(plain.error());
    QFile file(QString::fromStdString(path.string()));
    if (!file.open(QIODevice::ReadOnly))
        return failure("The file cannot be read", path.string(), "Check its permissions");
    if (std::uintmax_t(file.size()) > maxBytesOfRecord)
        return failure("The file is larger than any report", path.string(), {});
    return file.readAll();
}

Result<std::unique_ptr<Poppler::Document>> openPdf(const QByteArray& bytes,
                                                   const std::filesystem::path& path) {
    auto document = Poppler::Document::loadFromData(bytes);
    if (!document || document->isLocked() || document->numPages() > maxPagesOfReport)
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

constexpr double comparedDpi = 72;  // a letter of 8 pt has 8 points of height
constexpr double sameSizePt = 0.5;
// Of 255. The same page gives the same picture; a value below is no mark that a reader could see.
constexpr int visibleDifference = 24;

bool mustStop(const QVariant& stop) { return stop.value<const std::stop_token*>()->stop_requested(); }

QImage drawPage(const Poppler::Page& page, const std::stop_token& stop) {
    return page
        .renderToImage(comparedDpi, comparedDpi, -1, -1, -1, -1, Poppler::Page::Rotate0, nullptr, nullptr,
                       mustStop, QVariant::fromValue(&stop))
        .convertToFormat(QImage::Format_RGB32);
}

bool looksSame(const QImage& a, const QImage& b) {
    if (a.size() != b.size()) return false;
    const auto differs = [](QRgb one, QRgb other) {
        return std::abs(qRed(one) - qRed(other)) > visibleDifference ||
               std::abs(qGreen(one) - qGreen(other)) > visibleDifference ||
               std::abs(qBlue(one) - qBlue(other)) > visibleDifference;
    };
    for (int y = 0; y < a.height(); ++y) {
        const auto *line = reinterpret_cast<const QRgb*>(a.constScanLine(y)),
                   *other = reinterpret_cast<const QRgb*>(b.constScanLine(y));
        for (int x = 0; x < a.width(); ++x)
            if (differs(line[x], other[x])) return false;
    }
    return true;
}

// The size is that of a page of ours, so that a page of a kilometre is not drawn.
bool isSameSize(const Poppler::Page& a, const Poppler::Page& b) {
    const QSizeF one = a.pageSizeF(), other = b.pageSizeF();
    return std::abs(one.width() - other.width()) < sameSizePt &&
           std::abs(one.height() - other.height()) < sameSizePt;
}

void showAsViewersDo(Poppler::Document& document) {
    document.setRenderHint(Poppler::Document::Antialiasing);
    document.setRenderHint(Poppler::Document::TextAntialiasing);
}

bool isAmong(const std::vector<std::string_view>& names, const QString& name) {
    return std::ranges::find(names, name.toStdString()) != names.end();
}

}  // namespace

Result<FiledReport> readReport(const std::filesystem::path& path,
                               const std::vector<std::string_view>& recordNames) {
    const auto bytes = readBytes(path);
    if (!bytes) return tl::make_unexpected(bytes.error());
    if (!bytes->startsWith("%PDF"))
        return FiledReport{path.filename().string(), bytes->toStdString(), {}, false, true};
    const auto document = openPdf(*bytes, path);
    if (!document) return tl::make_unexpected(document.error());
    for (Poppler::EmbeddedFile* attached : (*document)->embeddedFiles())
        if (attached->isValid() && isAmong(recordNames, attached->name()))
            return FiledReport{attached->name().toStdString(), attached->data().toStdString(),
                               printedWords(**document), !(*document)->outline().isEmpty()};
    return failure("The PDF has no record of its result attached", path.string(),
                   "Give the record that was written beside it, such as study.json");
}

Result<PageComparison> comparePages(const std::filesystem::path& filed, const std::filesystem::path& computed,
                                    const std::stop_token& stop) {
    const auto filedBytes = readBytes(filed), computedBytes = readBytes(computed);
    if (!filedBytes) return tl::make_unexpected(filedBytes.error());
    if (!computedBytes) return tl::make_unexpected(computedBytes.error());
    const auto a = openPdf(*filedBytes, filed), b = openPdf(*computedBytes, computed);
    if (!a) return tl::make_unexpected(a.error());
    if (!b) return tl::make_unexpected(b.error());
    for (const auto* document : {&*a, &*b}) showAsViewersDo(**document);
    PageComparison result;
    for (int index = 0; index < std::max((*a)->numPages(), (*b)->numPages()); ++index) {
        const auto one = (*a)->page(index), other = (*b)->page(index);
        if (!one || !other || !isSameSize(*one, *other)) {
            result.onlyInOne.push_back(index + 1);
            continue;
        }
        ++result.pages;
        if (!looksSame(drawPage(*one, stop), drawPage(*other, stop))) result.different.push_back(index + 1);
        if (stop.stop_requested()) return cancelled();
    }
    return result;
}

Result<std::string> readPrintedWords(const std::filesystem::path& path) {
    const auto bytes = readBytes(path);
    if (!bytes) return tl::make_unexpected(bytes.error());
    const auto document = openPdf(*bytes, path);
    if (!document) return tl::make_unexpected(document.error());
    return printedWords(**document);
}

}  // namespace noonmark

#include "app/report/sheets/pdf_page.h"

#include <QPageSize>
#include <QPdfWriter>

#include "app/report/sheets/study_text.h"

namespace noonmark {

namespace {

constexpr int dotsPerInch = 1200;

}  // namespace

void beginPdf(QPdfWriter& writer, const QString& title) {
    writer.setResolution(dotsPerInch);
    writer.setPageSize(QPageSize(QPageSize::A4));
    writer.setPageMargins(QMarginsF(0, 0, 0, 0));
    writer.setTitle(title);
    writer.setCreator(describeProgram());
}

void attachRecord(const SheetRecord& record, QPdfWriter& writer) {
    if (!record.fileName.isEmpty())
        writer.addFileAttachment(record.fileName, QByteArray::fromStdString(record.json),
                                 QStringLiteral("application/json"));
}

Canvas pdfCanvas(QPainter& painter) { return {painter, dotsPerInch / 72.0}; }

}  // namespace noonmark

// Its headers warn unless the user says which smart pointers it expects: std::shared_ptr.
#define POINTERHOLDER_TRANSITION 4
#include <qpdf/Buffer.hh>
#include <qpdf/QPDF.hh>
#include <qpdf/QPDFObjectHandle.hh>
#include <qpdf/QPDFWriter.hh>

#include "app/report/book/pdf_structure.h"

namespace noonmark {

namespace {

using Object = QPDFObjectHandle;

Object textOf(const QString& text) { return Object::newUnicodeString(text.toStdString()); }

/// Adds entries below `parent` as long as their level is at least `level`. Returns how many, with all below
/// them.
int addEntries(QPDF& pdf, Object parent, const std::vector<PdfBookmark>& bookmarks, std::size_t& next,
               const std::vector<Object>& pages, int level) {
    Object before;
    int count = 0;
    while (next < bookmarks.size() && bookmarks[next].level >= level) {
        const PdfBookmark& bookmark = bookmarks[next++];
        Object entry = pdf.makeIndirectObject(Object::newDictionary());
        entry.replaceKey("/Title", textOf(bookmark.title));
        entry.replaceKey("/Parent", parent);
        Object target = Object::newArray();
        target.appendItem(pages.at(std::size_t(bookmark.page)));
        target.appendItem(Object::newName("/Fit"));
        entry.replaceKey("/Dest", target);
        if (before.isInitialized()) {
            entry.replaceKey("/Prev", before);
            before.replaceKey("/Next", entry);
        } else {
            parent.replaceKey("/First", entry);
        }
        parent.replaceKey("/Last", entry);
        count += 1 + addEntries(pdf, entry, bookmarks, next, pages, level + 1);
        before = entry;
    }
    if (count > 0) parent.replaceKey("/Count", Object::newInteger(count));
    return count;
}

void addLabels(Object root, const std::vector<QString>& labels) {
    Object numbers = Object::newArray();
    for (std::size_t i = 0; i < labels.size(); ++i) {
        numbers.appendItem(Object::newInteger(static_cast<long long>(i)));
        numbers.appendItem(Object::newDictionary({{"/P", textOf(labels[i])}}));
    }
    root.replaceKey("/PageLabels", Object::newDictionary({{"/Nums", numbers}}));
}

QByteArray withStructure(const QByteArray& bytes, const PdfStructure& structure) {
    QPDF pdf;
    pdf.setSuppressWarnings(true);
    pdf.processMemoryFile("book", bytes.constData(), std::size_t(bytes.size()));
    Object root = pdf.getRoot();
    root.replaceKey("/Lang", textOf(structure.language));
    root.replaceKey("/ViewerPreferences",
                    Object::newDictionary({{"/DisplayDocTitle", Object::newBool(true)}}));
    if (!structure.labels.empty()) addLabels(root, structure.labels);
    if (!structure.bookmarks.empty()) {
        Object outline = pdf.makeIndirectObject(Object::newDictionary());
        outline.replaceKey("/Type", Object::newName("/Outlines"));
        std::size_t next = 0;
        addEntries(pdf, outline, structure.bookmarks, next, pdf.getAllPages(), 0);
        root.replaceKey("/Outlines", outline);
        root.replaceKey("/PageMode", Object::newName("/UseOutlines"));
    }
    QPDFWriter writer(pdf);
    writer.setOutputMemory();
    writer.setObjectStreamMode(qpdf_o_generate);
    writer.write();
    const auto buffer = writer.getBufferSharedPointer();
    return {reinterpret_cast<const char*>(buffer->getBuffer()), qsizetype(buffer->getSize())};
}

}  // namespace

Result<QByteArray> addPdfStructure(const QByteArray& pdf, const PdfStructure& structure) {
    try {
        return withStructure(pdf, structure);
    } catch (const std::exception& error) {
        return internalError(std::string("The PDF could not be completed: ") + error.what());
    }
}

}  // namespace noonmark

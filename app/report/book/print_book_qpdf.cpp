#include "app/report/book/print_book.h"

#include <qpdf/qpdf-c.h>
#include <memory>
#include <optional>
#include <stdexcept>

namespace noonmark {

// By qpdf's C interface: Clang 14 cannot compile its C++ headers as C++20.

namespace {

using Object = qpdf_oh;

/// A PDF in memory. Its objects live as long as it does. Methods throw std::runtime_error with qpdf's words.
class Pdf {
public:
    explicit Pdf(const QByteArray& bytes) {
        qpdf_silence_errors(data());
        qpdf_set_suppress_warnings(data(), QPDF_TRUE);
        qpdf_read_memory(data(), "book", bytes.constData(), static_cast<unsigned long long>(bytes.size()),
                         nullptr);
        check();
    }

    [[nodiscard]] Object root() const { return checked(qpdf_get_root(data())); }
    [[nodiscard]] Object page(int number) const {
        return checked(qpdf_get_page_n(data(), static_cast<std::size_t>(number)));
    }
    [[nodiscard]] Object text(const QString& text) const {
        return checked(qpdf_oh_new_unicode_string(data(), text.toUtf8().constData()));
    }
    [[nodiscard]] Object name(const char* name) const { return checked(qpdf_oh_new_name(data(), name)); }
    [[nodiscard]] Object integer(long long value) const {
        return checked(qpdf_oh_new_integer(data(), value));
    }
    [[nodiscard]] Object yes() const { return checked(qpdf_oh_new_bool(data(), QPDF_TRUE)); }
    [[nodiscard]] Object array() const { return checked(qpdf_oh_new_array(data())); }
    [[nodiscard]] Object dictionary() const { return checked(qpdf_oh_new_dictionary(data())); }
    /// A dictionary that others can refer to.
    [[nodiscard]] Object sharedDictionary() const {
        return checked(qpdf_make_indirect_object(data(), dictionary()));
    }

    void set(Object dictionary, const char* key, Object value) const {
        qpdf_oh_replace_key(data(), dictionary, key, value);
        check();
    }
    void append(Object array, Object item) const {
        qpdf_oh_append_item(data(), array, item);
        check();
    }

    [[nodiscard]] QByteArray write() const {
        qpdf_init_write_memory(data());
        qpdf_set_object_stream_mode(data(), qpdf_o_generate);
        qpdf_write(data());
        check();
        return {reinterpret_cast<const char*>(qpdf_get_buffer(data())),
                qsizetype(qpdf_get_buffer_length(data()))};
    }

private:
    struct Cleanup {
        using pointer = qpdf_data;
        void operator()(qpdf_data data) const { qpdf_cleanup(&data); }
    };

    [[nodiscard]] qpdf_data data() const { return data_.get(); }
    void check() const {
        if (qpdf_has_error(data()) == QPDF_FALSE) return;
        throw std::runtime_error(qpdf_get_error_full_text(data(), qpdf_get_error(data())));
    }
    [[nodiscard]] Object checked(Object object) const {
        check();
        return object;
    }

    std::unique_ptr<qpdf_data, Cleanup> data_{qpdf_init()};
};

Object addEntry(const Pdf& pdf, Object parent, const PdfBookmark& bookmark) {
    const Object target = pdf.array();
    pdf.append(target, pdf.page(bookmark.page));
    pdf.append(target, pdf.name("/Fit"));
    const Object entry = pdf.sharedDictionary();
    pdf.set(entry, "/Title", pdf.text(bookmark.title));
    pdf.set(entry, "/Parent", parent);
    pdf.set(entry, "/Dest", target);
    return entry;
}

/// Adds entries below `parent` as long as their level is at least `level`. Returns how many, with all below
/// them.
int addEntries(const Pdf& pdf, Object parent, const std::vector<PdfBookmark>& bookmarks, std::size_t& next,
               int level) {
    std::optional<Object> before;
    int count = 0;
    while (next < bookmarks.size() && bookmarks[next].level >= level) {
        const Object entry = addEntry(pdf, parent, bookmarks[next++]);
        if (before) {
            pdf.set(entry, "/Prev", *before);
            pdf.set(*before, "/Next", entry);
        } else {
            pdf.set(parent, "/First", entry);
        }
        pdf.set(parent, "/Last", entry);
        count += 1 + addEntries(pdf, entry, bookmarks, next, level + 1);
        before = entry;
    }
    if (count > 0) pdf.set(parent, "/Count", pdf.integer(count));
    return count;
}

void addOutline(const Pdf& pdf, const std::vector<PdfBookmark>& bookmarks) {
    const Object outline = pdf.sharedDictionary();
    pdf.set(outline, "/Type", pdf.name("/Outlines"));
    std::size_t next = 0;
    addEntries(pdf, outline, bookmarks, next, 0);
    pdf.set(pdf.root(), "/Outlines", outline);
    pdf.set(pdf.root(), "/PageMode", pdf.name("/UseOutlines"));
}

void addLabels(const Pdf& pdf, const std::vector<QString>& labels) {
    const Object numbers = pdf.array();
    for (std::size_t i = 0; i < labels.size(); ++i) {
        const Object label = pdf.dictionary();
        pdf.set(label, "/P", pdf.text(labels[i]));
        pdf.append(numbers, pdf.integer(static_cast<long long>(i)));
        pdf.append(numbers, label);
    }
    const Object tree = pdf.dictionary();
    pdf.set(tree, "/Nums", numbers);
    pdf.set(pdf.root(), "/PageLabels", tree);
}

void showTitle(const Pdf& pdf) {
    const Object preferences = pdf.dictionary();
    pdf.set(preferences, "/DisplayDocTitle", pdf.yes());
    pdf.set(pdf.root(), "/ViewerPreferences", preferences);
}

}  // namespace

Result<QByteArray> addPdfStructure(const QByteArray& bytes, const PdfStructure& structure) {
    try {
        const Pdf pdf(bytes);
        pdf.set(pdf.root(), "/Lang", pdf.text(structure.language));
        showTitle(pdf);
        if (!structure.labels.empty()) addLabels(pdf, structure.labels);
        if (!structure.bookmarks.empty()) addOutline(pdf, structure.bookmarks);
        return pdf.write();
    } catch (const std::exception& error) {
        return internalError(std::string("The PDF could not be completed: ") + error.what());
    }
}

}  // namespace noonmark

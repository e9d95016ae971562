#pragma once

#include <QWidget>
#include <memory>

#include "app/gui/base/jobs/job.h"
#include "app/report/book/book.h"

class QComboBox;
class QLabel;
class QScrollArea;
class QSpinBox;

namespace noonmark {

/// Shows the pages of a book one at a time, as they are printed. Pages are painted in a job, so that large
/// diagrams do not hold up the window.
class BookView final : public QWidget {
    Q_OBJECT
public:
    explicit BookView(QWidget* parent = nullptr);

    /// Shows another book at the page last looked at; null: none, and `whyNone` in its place.
    void show(std::shared_ptr<const Book> book, const QString& whyNone = {});
    void showPage(int page);  ///< from 0
    [[nodiscard]] int page() const;
    [[nodiscard]] bool hasPages() const { return book_ && !book_->pages.empty(); }
    [[nodiscard]] bool busy() const { return painting_.busy(); }
    [[nodiscard]] const QImage& picture() const { return picture_; }  ///< of the page; null: not painted yet

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    QWidget* makeBar();
    void listChapters();
    void paint();
    void take(QImage picture);
    [[nodiscard]] double dotsPerInch() const;

    std::shared_ptr<const Book> book_;
    QString whyNone_;
    QWidget* bar_ = nullptr;
    QSpinBox* number_;
    QLabel* count_;
    QComboBox* chapters_;
    QComboBox* zoom_;
    QScrollArea* scroll_;
    QLabel* sheet_;
    QImage picture_;
    JobSlot painting_;
};

}  // namespace noonmark

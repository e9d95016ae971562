#pragma once

#include <QTreeWidget>

#include "app/questions/glazing_question.h"

namespace noonmark {

/// The windows of a review with their verdicts, those that get worse first, with the values of each criterion
/// before and after. Sorts by a click on a column.
class GlazingTable final : public QTreeWidget {
    Q_OBJECT
public:
    explicit GlazingTable(QWidget* parent = nullptr);

    /// Null: empties the table.
    void show(const std::shared_ptr<const GlazingAnswer>& answer);
    /// Emits described() for the current row again.
    void describeCurrent() { describe(currentItem()); }
    /// The chosen window, as index of GlazingStudy::windows.
    [[nodiscard]] std::optional<std::size_t> chosen() const;
    void choose(std::size_t window);  ///< with the signals of a new row, and scrolls to it
    /// The whole table as text with tabs, for spreadsheets.
    [[nodiscard]] QString text() const;

Q_SIGNALS:
    /// The sentence on the chosen window, and its times in the sun; empty: none is chosen.
    void described(QString words);
    void pointedAt(std::size_t window);  ///< the chosen row
    void wanted(std::size_t window);     ///< a click on a row, or Enter

private:
    void showColumns();
    void describe(const QTreeWidgetItem* item);
    [[nodiscard]] std::optional<std::size_t> windowOf(const QTreeWidgetItem* item) const;

    std::shared_ptr<const GlazingAnswer> answer_;
    std::vector<const GlazingReview*> rows_;  // of answer_
};

/// "512 windows: 16 get worse, 3 get better. After: 480 pass, 32 fail"
QString describeGlazingVerdicts(const GlazingStudy& study);

}  // namespace noonmark

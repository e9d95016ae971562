#pragma once

#include <QTreeWidget>
#include <QWidget>
#include <optional>

#include "app/gui/docks/review/glazing/verdict_links.h"
#include "app/questions/glazing_question.h"
#include "core/study/elements/place_elements.h"

class QComboBox;

namespace noonmark {

class ElementForm;

/// Which windows a rule is evaluated on: one in each bay and storey of facades, or those of a file.
class GlazingForm final : public QWidget {
    Q_OBJECT
public:
    explicit GlazingForm(QWidget* parent = nullptr);

    void show(const ElementSettings& windows);  ///< without a signal
    void setBuilding(const QString& id);        ///< the selected building; empty: none
    [[nodiscard]] ElementForm& elements() { return *form_; }

Q_SIGNALS:
    void edited(noonmark::ElementSettings windows);

private:
    QComboBox* source_;
    ElementForm* form_;
};

class GlazingTable;

/// The table of windows with their verdicts, and above it the choice of what the view shows of them.
class GlazingPanel final : public QWidget {
    Q_OBJECT
public:
    explicit GlazingPanel(QWidget* parent = nullptr);

    [[nodiscard]] GlazingTable& table() { return *table_; }
    [[nodiscard]] ShownVerdicts shown() const;
    void setShown(ShownVerdicts shown);  ///< as if the user had chosen it
    /// Another result is shown instead, until resumeShown() or a choice of the user.
    void suspend();
    void resumeShown();

Q_SIGNALS:
    void shownChanged();

private:
    QComboBox* choice_;
    GlazingTable* table_;
    std::optional<ShownVerdicts> away_;  ///< what resumeShown() shows
};

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
    void highlighted(std::size_t window);    ///< the chosen row
    void goToRequested(std::size_t window);  ///< a click on a row, or Enter

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

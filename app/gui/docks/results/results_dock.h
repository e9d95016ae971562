#pragma once

#include <QTreeWidget>
#include <QWidget>

#include "app/gui/session/answers/result_rows.h"
#include "core/base/warnings.h"
#include "core/describe/answer_page.h"

class QAction;
class QComboBox;
class QLabel;
class QPushButton;
class QScrollArea;
class QToolButton;

namespace noonmark {

class BarCharts;

/// The answer sheet of the displayed result, whatever was asked: the answer in a sentence, charts, figures;
/// how it was made is folded below, and what to do with it stands at the foot.
class ResultsDock final : public QWidget {
    Q_OBJECT
public:
    explicit ResultsDock(QWidget* parent = nullptr);

    /// Shows an answer; no rows: no result yet. Removes the note and the button back to the study.
    void show(const AnswerPage& page, const std::vector<ResultRow>& rows);
    /// Text above the figures; empty: none. `warns`: in amber, and the figures are greyed out, since they do
    /// not belong to what is displayed.
    void setNote(const QString& note, bool warns = true);
    /// The answers that can be shown, of which `shown` is; -1: none. A single one needs no list.
    void setAnswers(const QStringList& names, int shown);
    /// The columns that the result has beside that without trees, and the one that is shown; a result
    /// without any offers no choice.
    void setTrees(const std::vector<TreeColumns>& columns, TreeColumns shown);
    void setHint(const QString& hint);           ///< shown while there are no figures; empty: the default one
    void setWarningCount(std::size_t warnings);  ///< of the data; shown as a button
    /// The buttons at the foot trigger these.
    void setActions(QAction* save, QAction* compare, QAction* exporting);
    /// Puts a widget between the figures and how they were made.
    void addSection(QWidget* section);
    [[nodiscard]] bool faded() const { return faded_; }  ///< greyed out by a note that warns
    [[nodiscard]] const std::vector<ResultRow>& rows() const { return rows_; }
    [[nodiscard]] QString headline() const;
    void showBackButton(bool offered, bool toStudy);  ///< shows a button back to the study, or to none
    void showTop();                                   ///< scrolls to the headline
    /// What is shown is one of so many places: buttons back to all of them, and to what shades it. The next
    /// show() removes them.
    void offerAllPlaces(std::size_t places);

Q_SIGNALS:
    void studyRequested();
    void answerChosen(int answer);  ///< of setAnswers()
    void treesChosen(TreeColumns column);
    void commandRequested();   ///< on the clipboard
    void warningsRequested();  ///< their list
    void allPlacesRequested();
    void contributorsRequested();
    void subjectRequested(const QString& id);  ///< of a building or tree that a row is about

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void placeContent();
    void placeFoot();
    void fillRows(QWidget& widget, bool ofMethod);
    void showMethod();
    void fitLabels();
    void setFaded(bool faded);

    QScrollArea* scroll_;
    QComboBox* answers_;
    QComboBox* trees_;
    QLabel* headline_;
    QLabel* findings_;
    QLabel* note_;
    QPushButton* back_;
    QPushButton* allPlaces_;
    QPushButton* shadedBy_;
    BarCharts* charts_;
    QWidget* figures_;  ///< rows
    QWidget* sections_;
    QToolButton* howMade_;
    QWidget* method_;  ///< rows below howMade_
    QPushButton* command_;
    QPushButton* warnings_;
    QWidget* foot_;
    QString hint_;
    std::vector<ResultRow> rows_;
    bool filled_ = false;
    bool faded_ = false;
};

/// The warnings of reading: data that was repaired, left out or assumed, grouped by kind, with the ids of the
/// features.
class WarningsDock final : public QTreeWidget {
    Q_OBJECT
public:
    explicit WarningsDock(QWidget* parent = nullptr);
    void show(const Warnings& warnings);

Q_SIGNALS:
    void placeChosen(QString where);  ///< double click or Enter on a warning's place
};

}  // namespace noonmark

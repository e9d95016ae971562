#pragma once

#include <QWidget>

#include "app/gui/session/answers/result_rows.h"
#include "scenarios/weights/score.h"

class QFormLayout;
class QLabel;
class QPushButton;

namespace noonmark {

class MonthChart;

/// The figures of the displayed result: a study, comparison, score or saved result.
class ResultsDock final : public QWidget {
    Q_OBJECT
public:
    explicit ResultsDock(QWidget* parent = nullptr);

    /// Shows these figures; none: no result yet. `months`: of a score, as charts. Removes the note and the
    /// button back to the study.
    void show(const std::vector<ResultRow>& rows, const std::vector<MonthFigures>& months = {});
    /// Text above the figures; empty: none. `warns`: in amber, and the figures are greyed out, since they do
    /// not belong to what is displayed.
    void setNote(const QString& note, bool warns = true);
    void setHint(const QString& hint);  ///< shown while there are no figures; empty: the usual one
    [[nodiscard]] bool faded() const { return faded_; }  ///< greyed out by a note that warns
    [[nodiscard]] const std::vector<ResultRow>& rows() const { return rows_; }
    void offerWayBack(bool offered);  ///< shows a button back to the study

Q_SIGNALS:
    void studyWanted();

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void fitNote();
    void setFaded(bool faded);

    QLabel* note_;
    QPushButton* back_;
    MonthChart* months_;
    QFormLayout* form_;
    QString hint_;
    std::vector<ResultRow> rows_;
    int fixedRows_ = 0;  // the rows above the figures
    bool filled_ = false;
    bool faded_ = false;
};

}  // namespace noonmark

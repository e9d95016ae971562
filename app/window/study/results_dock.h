#pragma once

#include <QWidget>

#include "app/window/study/result_rows.h"
#include "scenarios/weights/score.h"

class QFormLayout;
class QLabel;
class QPushButton;

namespace noonmark {

class MonthChart;

/// The figures of the latest study, comparison or score, or of a kept result.
class ResultsDock final : public QWidget {
    Q_OBJECT
public:
    explicit ResultsDock(QWidget* parent = nullptr);

    /// None: no result yet. `months`: of a score, as charts. Takes the note and the way back away.
    void show(const std::vector<ResultRow>& rows, const std::vector<MonthFigures>& months = {});
    /// Above the figures; empty: nothing. `warns`: in amber, and the figures are pale: they are not of what
    /// is shown.
    void setNote(const QString& note, bool warns = true);
    void setHint(const QString& hint);                   ///< in place of figures, until there are some
    [[nodiscard]] bool faded() const { return faded_; }  ///< by a note that warns
    void offerWayBack(bool offered);                     ///< to the study that these figures stand before

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
    int fixedRows_ = 0;  // the figures follow
    bool filled_ = false;
    bool faded_ = false;
};

}  // namespace noonmark

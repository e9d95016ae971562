#pragma once

#include <QWidget>

#include "core/study/study.h"

class QComboBox;
class QLabel;
class QPushButton;

namespace noonmark {

/// Where: a region or place by name, a drawn region, the view, the whole city or a building's surroundings.
class WhereForm final : public QWidget {
    Q_OBJECT
public:
    explicit WhereForm(QWidget* parent = nullptr);

    void show(const StudySettings& settings);  ///< without a signal
    void setDrawing(bool drawing);             ///< while a region is being drawn
    void setNames(const QStringList& names);   ///< of regions and places that can be chosen
    void setBuilding(bool selected);           ///< a building is selected

Q_SIGNALS:
    void drawRequested(bool draw);
    void viewRequested();
    void wholeCityRequested();
    void surroundingsRequested();     ///< of the selected building
    void named(const QString& name);  ///< of the list, or typed

private:
    void makeList();
    QWidget* makeButtons();
    void showName();

    QComboBox* names_;
    QPushButton* draw_;
    QPushButton* surroundings_;
    QLabel* region_;
    QString name_;
};

}  // namespace noonmark

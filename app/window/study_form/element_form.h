#pragma once

#include <QWidget>

#include "core/study/elements/place_elements.h"

class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class QLineEdit;
class QPushButton;

namespace noonmark {

/// Where points lie: of which buildings' facades, on which windows of a file, or how high a plane is.
class ElementForm final : public QWidget {
    Q_OBJECT
public:
    /// A rule states itself how high above a floor its windows are, and is about the whole city.
    enum class Use { study, rule };
    explicit ElementForm(Use use = Use::study, QWidget* parent = nullptr);

    void show(const ElementSettings& settings);  ///< without a signal
    void setBuilding(const QString& id);         ///< the selected building; empty: none
    [[nodiscard]] const ElementSettings& settings() const { return settings_; }

Q_SIGNALS:
    void edited(noonmark::ElementSettings settings, QString field);  ///< the name of the field

private:
    void makeFields();
    QWidget* makeBuildings();
    QWidget* makeFile();
    void placeFields();
    void connectFields();
    void browse();
    void toggleBuilding();
    void showRows();
    void showButton();

    Use use_;
    ElementSettings settings_;
    QString building_;
    QLineEdit* buildings_;  ///< ids or names with commas; empty: all of the region
    QPushButton* selected_;
    QDoubleSpinBox* bay_;
    QDoubleSpinBox* storey_;
    QDoubleSpinBox* aboveFloor_;
    QLineEdit* file_;
    QPushButton* browse_;
    QComboBox* heights_;
    QDoubleSpinBox* plane_;
    QFormLayout* form_;
};

}  // namespace noonmark

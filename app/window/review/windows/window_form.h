#pragma once

#include <QWidget>

#include "app/window/review/review_choice.h"

class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class QLineEdit;
class QPushButton;

namespace noonmark {

/// Which windows a rule is evaluated on: those of a file, or one in each bay and storey of facades.
class WindowForm final : public QWidget {
    Q_OBJECT
public:
    explicit WindowForm(QWidget* parent = nullptr);

    void show(const WindowChoice& choice);
    /// The building that a button adds to the list; empty: none is selected.
    void setSelected(const QString& id);

Q_SIGNALS:
    void edited(noonmark::WindowChoice choice);

private:
    void take();
    void chooseFile();
    void addSelected();
    void showSource();

    QFormLayout* form_;
    QComboBox* source_;
    QLineEdit* file_;
    QLineEdit* buildings_;
    QPushButton* addSelected_;
    QWidget* fileRow_;
    QWidget* buildingsRow_;
    QString selected_;
    QDoubleSpinBox* bay_;
    QDoubleSpinBox* storey_;
};

}  // namespace noonmark

#pragma once

#include <QWidget>

#include "core/io/read_city.h"

class QCheckBox;
class QDoubleSpinBox;
class QGroupBox;
class QPushButton;

namespace noonmark {

class FieldRows;

/// Fields for ReadSettings: what a file may not state. ReadSettings::frame has no field and stays empty.
class ReadingForm final : public QWidget {
    Q_OBJECT
public:
    explicit ReadingForm(QWidget* parent = nullptr);

    [[nodiscard]] ReadSettings settings() const;
    void show(const ReadSettings& settings);
    void setMiddle(std::optional<LonLat> middle);  ///< of the open city; none: disables the button

Q_SIGNALS:
    void edited();  ///< by the user

private:
    void makeFields();
    QGroupBox* makeHeights();
    QGroupBox* makeData();
    QGroupBox* makeMeshes();
    QWidget* makeAnchor();
    void showAnchor(LonLat place);

    FieldRows* rows_;
    QCheckBox* anchored_;
    QDoubleSpinBox* longitude_;
    QDoubleSpinBox* latitude_;
    QPushButton* toMiddle_;
    std::optional<LonLat> middle_;
};

}  // namespace noonmark

#pragma once

#include <QDialog>
#include <array>

namespace noonmark {

class LengthField;
class SectionTool;
class ViewPanel;

/// The sides of the section box as numbers. It stays open beside the view, whose handles are shown as long.
class SectionDialog final : public QDialog {
    Q_OBJECT
public:
    SectionDialog(ViewPanel& panel, QWidget* parent);  ///< `panel` must outlive it

Q_SIGNALS:
    void removed();  ///< the box is no longer wanted

protected:
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;

private:
    void addFields();
    void addButtons();
    void showBox();
    void takeField(std::size_t side);
    void takeView();

    ViewPanel& panel_;
    SectionTool& tool_;
    std::array<LengthField*, 6> fields_{};  ///< by sectionSides
};

}  // namespace noonmark

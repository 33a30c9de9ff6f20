#pragma once
// Exposure and the five parameters of the line extraction, in use and on trial, and what the trial does to the chosen
// camera's picture: pixels of both, points gained and lost, shift.

#include <array>
#include <memory>
#include <optional>

#include "engine/stripe/stripe.h"
#include "gui/stripes/stripe_picture.h"
#include "gui/theme/panel.h"
#include "gui/theme/theme.h"

class QDoubleSpinBox;
class QGridLayout;
class QLabel;
class QLineEdit;
class QPushButton;
class QTableWidget;

namespace vignole {

class PixelView;

class TrialPanel : public Panel {
  Q_OBJECT

 public:
  static constexpr std::size_t kFields = 6;  ///< exposure, sigma, t_l, t_h, d, alpha

  explicit TrialPanel(const Theme& theme, QWidget* parent = nullptr);

  /// Sets what is on trial back to it. Without an exposure: the source does not tell it.
  void setInUse(const StripeSettings& settings, std::optional<double> exposureMs, bool exposureCanChange);
  [[nodiscard]] StripeSettings stripeOnTrial() const;
  [[nodiscard]] std::optional<double> exposureOnTrial() const;  ///< if it differs from the one in use
  [[nodiscard]] bool stripeDiffers() const;
  [[nodiscard]] bool differs() const { return stripeDiffers() || exposureOnTrial(); }
  /// "sigma 2.2 -> 4; ...", for records.
  [[nodiscard]] std::string changes() const;
  void discard();

  void setCamera(int camera);
  void setFrozen(bool frozen);
  void setMay(bool mayApply);
  void setMessage(const QString& message);
  void showPicture(const std::shared_ptr<const StripePicture>& picture);
  void setCompact(bool compact);
  [[nodiscard]] QString reason() const;
  void askForReason();
  void clearReason();
  [[nodiscard]] QString message() const;
  [[nodiscard]] const QTableWidget& comparison() const { return *comparison_; }

 signals:
  void trialChanged();
  void applyAsked();
  void discardAsked();
  void freezeAsked();
  void profileAsked();
  void saveAsked();
  void cameraAsked(int camera);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void makeFields();
  void makeComparison();
  void makeButtons();
  void layOutFields();
  void retranslate();
  void showMarks();
  void compare();
  [[nodiscard]] double inUse(std::size_t field) const;
  [[nodiscard]] bool differs(std::size_t field) const;

  const Theme& theme_;
  StripeSettings inUse_;
  std::optional<double> exposureMs_;
  std::shared_ptr<const StripePicture> picture_;
  int camera_ = 0;
  bool frozen_ = false, may_ = false, compact_ = false;
  QGridLayout* form_;
  std::array<QLabel*, 3> heads_{};
  std::array<QLabel*, kFields> words_{}, symbols_{}, used_{};
  std::array<QDoubleSpinBox*, kFields> fields_{};
  std::array<QPushButton*, kFields> less_{}, more_{};
  std::array<QPushButton*, kCameraCount> cameras_{};
  std::array<PixelView*, 2> pixels_{};
  std::array<QLabel*, 2> captions_{};
  QTableWidget* comparison_;
  QLineEdit* reason_;
  QLabel* message_;
  QPushButton *freeze_, *profile_, *save_, *discard_, *apply_;
};

}  // namespace vignole

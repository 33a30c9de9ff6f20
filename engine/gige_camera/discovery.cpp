#include <mutex>

#include "engine/gige_camera/arv_objects.h"
#include "engine/gige_camera/gige_source.h"

namespace vignole {

std::vector<GigeIdentity> discover() {
  static std::mutex one;  // Aravis keeps one list of devices
  const std::scoped_lock lock(one);
  arv_update_device_list();
  const auto text = [](const char* from) { return from == nullptr ? std::string() : std::string(from); };
  std::vector<GigeIdentity> found;
  for (unsigned i = 0; i < arv_get_n_devices(); ++i) {
    if (text(arv_get_device_protocol(i)) != "GigEVision") continue;
    GigeIdentity camera;
    camera.address = text(arv_get_device_address(i));
    camera.serial = text(arv_get_device_serial_nbr(i));
    camera.vendor = text(arv_get_device_vendor(i));
    camera.model = text(arv_get_device_model(i));
    camera.manufacturerInfo = text(arv_get_device_manufacturer_info(i));
    found.push_back(std::move(camera));
  }
  return found;
}

}  // namespace vignole

# What lasius::arm links, found by pkg-config: used by the build, and by the installed package where
# the libraries are static. Sets LASIUS_ARM_LIBRARIES_FOUND.
find_package(PkgConfig QUIET)
find_package(Eigen3 QUIET NO_MODULE)
find_package(nlohmann_json QUIET)
set(LASIUS_ARM_LIBRARIES_FOUND OFF)
if(PkgConfig_FOUND AND TARGET Eigen3::Eigen)
  pkg_check_modules(LASIUS_KDL QUIET IMPORTED_TARGET orocos-kdl)
  pkg_check_modules(LASIUS_URDFDOM QUIET IMPORTED_TARGET urdfdom)
  pkg_check_modules(LASIUS_TINYXML QUIET IMPORTED_TARGET tinyxml)  # urdfdom's own
  pkg_check_modules(LASIUS_ASSIMP QUIET IMPORTED_TARGET assimp)
  pkg_check_modules(LASIUS_YAML QUIET IMPORTED_TARGET yaml-cpp)
  if(LASIUS_KDL_FOUND AND LASIUS_URDFDOM_FOUND AND LASIUS_TINYXML_FOUND AND LASIUS_ASSIMP_FOUND AND
     LASIUS_YAML_FOUND AND
     (nlohmann_json_FOUND OR NOT PROJECT_NAME STREQUAL "lasius"))
    set(LASIUS_ARM_LIBRARIES_FOUND ON)
  endif()
endif()

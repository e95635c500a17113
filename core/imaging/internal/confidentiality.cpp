// The attributes of MR, CT and segmentations (PS3.3 A.2 to A.4, A.36, A.38, A.51) that say how an image was acquired,
// where it lies and how its pixels are stored. There is one set for each way of handling them.

#include "imaging/internal/confidentiality.h"

#include <algorithm>
#include <set>

#include "imaging/internal/dicom_fields.h"

namespace glisson::imaging {
namespace {

using Tags = std::set<DcmTagKey>;

// Action Z: what must be there but may be empty (type 2), wherever it stands.
const Tags& emptied() {
  static const Tags tags = {DCM_StudyDate,
                            DCM_StudyTime,
                            DCM_AccessionNumber,
                            DCM_StudyID,
                            DCM_PatientName,
                            DCM_PatientID,
                            DCM_PatientBirthDate,
                            DCM_PatientSex,
                            DCM_ContentDate,
                            DCM_ContentTime,
                            DCM_ReferringPhysicianName,
                            DCM_ContentCreatorName,
                            DCM_ContentDescription,
                            DCM_ContrastBolusAgent,
                            DCM_PositionReferenceIndicator,
                            DCM_AcquisitionContextSequence};
  return tags;
}

// Action D: texts that some class of image must hold.
const Tags& placeholders() {
  static const Tags tags = {DCM_ManufacturerModelName, DCM_SoftwareVersions,
                            DCM_DeviceSerialNumber,    DCM_PulseSequenceName,
                            DCM_ReceiveCoilName,       DCM_ReceiveCoilManufacturerName,
                            DCM_TransmitCoilName,      DCM_TransmitCoilManufacturerName,
                            DCM_MultiCoilElementName,  DCM_SegmentAlgorithmName,
                            DCM_LUTExplanation,        DCM_LUTLabel};
  return tags;
}

// Sequences that describe frames, segments, dimensions and other images. What a person, a request, a procedure or an
// earlier version of the file is told in, goes whole.
const Tags& sequences() {
  static const Tags tags = {DCM_SharedFunctionalGroupsSequence,
                            DCM_PerFrameFunctionalGroupsSequence,
                            DCM_PixelMeasuresSequence,
                            DCM_PlanePositionSequence,
                            DCM_PlaneOrientationSequence,
                            DCM_FrameContentSequence,
                            DCM_FrameVOILUTSequence,
                            DCM_PixelValueTransformationSequence,
                            DCM_RealWorldValueMappingSequence,
                            DCM_FrameAnatomySequence,
                            DCM_DerivationImageSequence,
                            DCM_ReferencedImageSequence,
                            DCM_MRImageFrameTypeSequence,
                            DCM_MRTimingAndRelatedParametersSequence,
                            DCM_MRFOVGeometrySequence,
                            DCM_MREchoSequence,
                            DCM_MRModifierSequence,
                            DCM_MRImagingModifierSequence,
                            DCM_MRReceiveCoilSequence,
                            DCM_MRTransmitCoilSequence,
                            DCM_MRDiffusionSequence,
                            DCM_MRAveragesSequence,
                            DCM_MRSpatialSaturationSequence,
                            DCM_MRMetaboliteMapSequence,
                            DCM_MRVelocityEncodingSequence,
                            DCM_MRArterialSpinLabelingSequence,
                            DCM_MultiCoilDefinitionSequence,
                            DCM_DiffusionGradientDirectionSequence,
                            DCM_DiffusionBMatrixSequence,
                            DCM_SpecificAbsorptionRateSequence,
                            DCM_VelocityEncodingAcquisitionSequence,
                            DCM_CardiacSynchronizationSequence,
                            DCM_RespiratorySynchronizationSequence,
                            DCM_TemporalPositionSequence,
                            DCM_CTImageFrameTypeSequence,
                            DCM_CTAcquisitionTypeSequence,
                            DCM_CTAcquisitionDetailsSequence,
                            DCM_CTTableDynamicsSequence,
                            DCM_CTPositionSequence,
                            DCM_CTGeometrySequence,
                            DCM_CTReconstructionSequence,
                            DCM_CTExposureSequence,
                            DCM_CTXRayDetailsSequence,
                            DCM_SegmentIdentificationSequence,
                            DCM_SegmentSequence,
                            DCM_SegmentedPropertyCategoryCodeSequence,
                            DCM_SegmentedPropertyTypeCodeSequence,
                            DCM_SegmentedPropertyTypeModifierCodeSequence,
                            DCM_AnatomicRegionSequence,
                            DCM_AnatomicRegionModifierSequence,
                            DCM_DimensionOrganizationSequence,
                            DCM_DimensionIndexSequence,
                            DCM_ReferencedSeriesSequence,
                            DCM_ReferencedInstanceSequence,
                            DCM_SourceImageSequence,
                            DCM_DerivationCodeSequence,
                            DCM_PurposeOfReferenceCodeSequence,
                            DCM_MeasurementUnitsCodeSequence};
  return tags;
}

// Attributes that choose among terms which the standard defines.
const Tags& terms() {
  static const Tags tags = {DCM_Modality,
                            DCM_ConversionType,
                            DCM_PresentationIntentType,
                            DCM_PatientPosition,
                            DCM_Laterality,
                            DCM_ImageLaterality,
                            DCM_FrameLaterality,
                            DCM_ScanningSequence,
                            DCM_SequenceVariant,
                            DCM_ScanOptions,
                            DCM_MRAcquisitionType,
                            DCM_AngioFlag,
                            DCM_ImagedNucleus,
                            DCM_InPlanePhaseEncodingDirection,
                            DCM_VariableFlipAngleFlag,
                            DCM_RotationDirection,
                            DCM_ExposureModulationType,
                            DCM_AcquisitionType,
                            DCM_PhotometricInterpretation,
                            DCM_BurnedInAnnotation,
                            DCM_RecognizableVisualFeatures,
                            DCM_LossyImageCompression,
                            DCM_LossyImageCompressionMethod,
                            DCM_PresentationLUTShape,
                            DCM_VOILUTFunction,
                            DCM_PixelIntensityRelationship,
                            DCM_ContentQualification,
                            DCM_PixelPresentation,
                            DCM_VolumetricProperties,
                            DCM_VolumeBasedCalculationTechnique,
                            DCM_ComplexImageComponent,
                            DCM_AcquisitionContrast,
                            DCM_DimensionOrganizationType,
                            DCM_FrameAcquisitionDuration,
                            DCM_EchoPulseSequence,
                            DCM_InversionRecovery,
                            DCM_FlowCompensation,
                            DCM_MultipleSpinEcho,
                            DCM_MultiPlanarExcitation,
                            DCM_PhaseContrast,
                            DCM_TimeOfFlightContrast,
                            DCM_Spoiling,
                            DCM_SteadyStatePulseSequence,
                            DCM_EchoPlanarPulseSequence,
                            DCM_MagnetizationTransfer,
                            DCM_T2Preparation,
                            DCM_BloodSignalNulling,
                            DCM_SaturationRecovery,
                            DCM_SpectrallySelectedSuppression,
                            DCM_SpectrallySelectedExcitation,
                            DCM_SpatialPresaturation,
                            DCM_Tagging,
                            DCM_OversamplingPhase,
                            DCM_GeometryOfKSpaceTraversal,
                            DCM_SegmentedKSpaceTraversal,
                            DCM_RectilinearPhaseEncodeReordering,
                            DCM_PartialFourier,
                            DCM_PartialFourierDirection,
                            DCM_ParallelAcquisition,
                            DCM_ParallelAcquisitionTechnique,
                            DCM_KSpaceFiltering,
                            DCM_CoverageOfKSpace,
                            DCM_ResonantNucleus,
                            DCM_ReceiveCoilType,
                            DCM_TransmitCoilType,
                            DCM_QuadratureReceiveCoil,
                            DCM_DiffusionDirectionality,
                            DCM_DiffusionAnisotropyType,
                            DCM_ApplicableSafetyStandardAgency,
                            DCM_CardiacSynchronizationTechnique,
                            DCM_RespiratoryMotionCompensationTechnique,
                            DCM_SegmentationType,
                            DCM_SegmentationFractionalType,
                            DCM_SegmentAlgorithmType,
                            DCM_SegmentsOverlap,
                            DCM_ContentLabel,
                            DCM_ReconstructionAlgorithm,
                            DCM_ConvolutionKernelGroup};
  return tags;
}

// Numbers outside of the groups of numbers.
const Tags& further_numbers() {
  static const Tags tags = {DCM_ReferencedFrameNumber, DCM_RealWorldValueIntercept, DCM_RealWorldValueSlope,
                            DCM_RealWorldValueFirstValueMapped, DCM_RealWorldValueLastValueMapped};
  return tags;
}

// Tables of values, whose length nobody bounds, and what describes them.
bool is_lookup_table(const DcmTagKey& key) {
  if (key.getGroup() != 0x0028) return false;
  const unsigned element = key.getElement();
  return (element >= 0x1100 && element <= 0x1224) || element == 0x3002 || element == 0x3006;
}

bool is_numeric_kind(DcmEVR kind) {
  switch (kind) {
    case EVR_DS:
    case EVR_IS:
    case EVR_FD:
    case EVR_FL:
    case EVR_US:
    case EVR_SS:
    case EVR_UL:
    case EVR_SL:
    case EVR_xs:
    case EVR_AT: return true;
    default: return false;
  }
}

}  // namespace

Handling handling_of(const DcmTagKey& key) {
  const DcmTag known(key.getGroup(), key.getElement());
  const DcmEVR kind = known.getEVR();
  if ((key.getGroup() & 1) != 0 || kind == EVR_UN || kind == EVR_UNKNOWN) return Handling::remove;
  if (emptied().contains(key)) return Handling::empty;
  if (placeholders().contains(key)) return Handling::placeholder;
  if (terms().contains(key)) return Handling::term;
  if (key == DCM_ImageType || key == DCM_FrameType) return Handling::image_type;
  if (key == DCM_SOPClassUID || key == DCM_ReferencedSOPClassUID) return Handling::class_uid;
  if (key == DCM_CodeValue || key == DCM_CodingSchemeDesignator || key == DCM_CodeMeaning) return Handling::code;
  if (key == DCM_SegmentLabel) return Handling::segment_name;
  if (key == DCM_Manufacturer) return Handling::vendor;
  if (key == DCM_RescaleType) return Handling::unit;
  if (key == DCM_StackID) return Handling::stack;
  if (kind == EVR_SQ) return sequences().contains(key) ? Handling::sequence : Handling::remove;
  if (kind == EVR_UI) return Handling::new_uid;
  const unsigned group = key.getGroup();
  const bool group_of_numbers = group == 0x0018 || group == 0x0020 || group == 0x0028 || group == 0x0062;
  const bool numbers = is_numeric_kind(kind) && group_of_numbers && !is_lookup_table(key) && key.getElement() != 0;
  return numbers || further_numbers().contains(key) ? Handling::number : Handling::remove;
}

bool has_its_own_kind(DcmElement& element) {
  const DcmTagKey key = element.getTag().getXTag();
  const DcmEVR kind = DcmTag(key.getGroup(), key.getElement()).getEVR(), claimed = element.ident();
  if (kind == EVR_xs) return claimed == EVR_US || claimed == EVR_SS || claimed == EVR_xs;
  return kind == claimed;
}

bool holds_only_numbers(DcmElement& element) {
  const DcmTagKey key = element.getTag().getXTag();
  const DcmEVR kind = element.ident();
  const DcmDictEntry* entry = dcmDataDict.rdlock().findEntry(key, nullptr);
  const int maximum = entry == nullptr ? 0 : entry->getVMMax();
  dcmDataDict.rdunlock();
  const unsigned long count = element.getVM();
  if (maximum != DcmVariableVM && count > static_cast<unsigned long>(maximum)) return false;
  if (kind != EVR_DS && kind != EVR_IS) {
    // As many as somebody likes: a place for a text.
    return maximum != DcmVariableVM || count <= 1 || key == DCM_DimensionIndexValues ||
           key == DCM_FrameIncrementPointer;
  }
  OFString all;
  if (element.getOFStringArray(all).bad()) return false;
  bool numbers = true;
  const std::size_t longest = kind == EVR_DS ? 16 : 12;
  each_part(std::string_view(all.c_str(), all.size()), "\\", [&](std::string_view value) {
    const std::string_view number = without_padding(value);
    const std::string_view allowed = kind == EVR_DS ? "0123456789+-.eE" : "0123456789+-";
    numbers = numbers && number.size() <= longest && number.find_first_not_of(allowed) == std::string::npos &&
              (number.empty() || number.find_first_of("0123456789") != std::string::npos);
  });
  return numbers;
}

}  // namespace glisson::imaging

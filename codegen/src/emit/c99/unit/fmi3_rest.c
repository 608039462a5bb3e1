/* Functions that the description does not offer. */

static fmi3Status none(fmi3Instance instance, size_t count)
{
    if ((instance != NULL) && (count == 0u)) {
        return fmi3OK;
    }
    return refuse((instance_t *)instance, "there are no such variables");
}

#define NONE_OF(Type)                                                                             \
    fmi3Status fmi3Get##Type(fmi3Instance instance, const fmi3ValueReference references[],        \
                             size_t count, fmi3##Type values[], size_t nValues)                   \
    {                                                                                             \
        (void)references;                                                                         \
        (void)values;                                                                             \
        (void)nValues;                                                                            \
        return none(instance, count);                                                             \
    }                                                                                             \
    fmi3Status fmi3Set##Type(fmi3Instance instance, const fmi3ValueReference references[],        \
                             size_t count, const fmi3##Type values[], size_t nValues)             \
    {                                                                                             \
        (void)references;                                                                         \
        (void)values;                                                                             \
        (void)nValues;                                                                            \
        return none(instance, count);                                                             \
    }

NONE_OF(Float32)
NONE_OF(Int8)
NONE_OF(UInt8)
NONE_OF(Int16)
NONE_OF(UInt16)
NONE_OF(UInt32)
NONE_OF(Int64)
NONE_OF(UInt64)
NONE_OF(Boolean)
NONE_OF(String)

fmi3Status fmi3GetBinary(fmi3Instance instance, const fmi3ValueReference valueReferences[],
                         size_t nValueReferences, size_t valueSizes[], fmi3Binary values[],
                         size_t nValues)
{
    (void)valueReferences;
    (void)valueSizes;
    (void)values;
    (void)nValues;
    return none(instance, nValueReferences);
}

fmi3Status fmi3SetBinary(fmi3Instance instance, const fmi3ValueReference valueReferences[],
                         size_t nValueReferences, const size_t valueSizes[],
                         const fmi3Binary values[], size_t nValues)
{
    (void)valueReferences;
    (void)valueSizes;
    (void)values;
    (void)nValues;
    return none(instance, nValueReferences);
}

#define NONE_OF_CLOCKS(function, Value)                                                           \
    fmi3Status function(fmi3Instance instance, const fmi3ValueReference references[],             \
                        size_t count, Value values[])                                             \
    {                                                                                             \
        (void)references;                                                                         \
        (void)values;                                                                             \
        return none(instance, count);                                                             \
    }
#define NONE_OF_CLOCK_PAIRS(function, First, Second)                                              \
    fmi3Status function(fmi3Instance instance, const fmi3ValueReference references[],             \
                        size_t count, First first[], Second second[])                             \
    {                                                                                             \
        (void)references;                                                                         \
        (void)first;                                                                              \
        (void)second;                                                                             \
        return none(instance, count);                                                             \
    }

NONE_OF_CLOCKS(fmi3GetClock, fmi3Clock)
NONE_OF_CLOCKS(fmi3SetClock, const fmi3Clock)
NONE_OF_CLOCKS(fmi3GetShiftDecimal, fmi3Float64)
NONE_OF_CLOCKS(fmi3SetShiftDecimal, const fmi3Float64)
NONE_OF_CLOCKS(fmi3SetIntervalDecimal, const fmi3Float64)
NONE_OF_CLOCK_PAIRS(fmi3GetIntervalDecimal, fmi3Float64, fmi3IntervalQualifier)
NONE_OF_CLOCK_PAIRS(fmi3GetShiftFraction, fmi3UInt64, fmi3UInt64)
NONE_OF_CLOCK_PAIRS(fmi3SetShiftFraction, const fmi3UInt64, const fmi3UInt64)
NONE_OF_CLOCK_PAIRS(fmi3SetIntervalFraction, const fmi3UInt64, const fmi3UInt64)

fmi3Status fmi3GetIntervalFraction(fmi3Instance instance,
                                   const fmi3ValueReference valueReferences[],
                                   size_t nValueReferences, fmi3UInt64 counters[],
                                   fmi3UInt64 resolutions[], fmi3IntervalQualifier qualifiers[])
{
    (void)valueReferences;
    (void)counters;
    (void)resolutions;
    (void)qualifiers;
    return none(instance, nValueReferences);
}

fmi3Status fmi3GetNumberOfVariableDependencies(fmi3Instance instance,
                                               fmi3ValueReference valueReference,
                                               size_t *nDependencies)
{
    (void)valueReference;
    (void)nDependencies;
    return refuse((instance_t *)instance, "dependencies are those of the description");
}

fmi3Status fmi3GetVariableDependencies(fmi3Instance instance, fmi3ValueReference dependent,
                                       size_t elementIndicesOfDependent[],
                                       fmi3ValueReference independents[],
                                       size_t elementIndicesOfIndependents[],
                                       fmi3DependencyKind dependencyKinds[], size_t nDependencies)
{
    (void)dependent;
    (void)elementIndicesOfDependent;
    (void)independents;
    (void)elementIndicesOfIndependents;
    (void)dependencyKinds;
    (void)nDependencies;
    return refuse((instance_t *)instance, "dependencies are those of the description");
}

#define NO_DERIVATIVE(function)                                                                   \
    fmi3Status function(fmi3Instance instance, const fmi3ValueReference unknowns[],               \
                        size_t nUnknowns, const fmi3ValueReference knowns[], size_t nKnowns,      \
                        const fmi3Float64 seed[], size_t nSeed, fmi3Float64 sensitivity[],        \
                        size_t nSensitivity)                                                      \
    {                                                                                             \
        (void)unknowns;                                                                           \
        (void)nUnknowns;                                                                          \
        (void)knowns;                                                                             \
        (void)nKnowns;                                                                            \
        (void)seed;                                                                               \
        (void)nSeed;                                                                              \
        (void)sensitivity;                                                                        \
        (void)nSensitivity;                                                                       \
        return refuse((instance_t *)instance, "there are no derivatives of outputs");             \
    }

NO_DERIVATIVE(fmi3GetDirectionalDerivative)
NO_DERIVATIVE(fmi3GetAdjointDerivative)

fmi3Status fmi3GetOutputDerivatives(fmi3Instance instance,
                                    const fmi3ValueReference valueReferences[],
                                    size_t nValueReferences, const fmi3Int32 orders[],
                                    fmi3Float64 values[], size_t nValues)
{
    (void)valueReferences;
    (void)nValueReferences;
    (void)orders;
    (void)values;
    (void)nValues;
    return refuse((instance_t *)instance, "there are no derivatives of outputs");
}

fmi3Status fmi3EnterConfigurationMode(fmi3Instance instance)
{
    return refuse((instance_t *)instance, "there are no structural parameters");
}

fmi3Status fmi3ExitConfigurationMode(fmi3Instance instance)
{
    return refuse((instance_t *)instance, "there are no structural parameters");
}

fmi3Status fmi3EvaluateDiscreteStates(fmi3Instance instance)
{
    return refuse((instance_t *)instance, "discrete states are not evaluated without an update");
}

fmi3Status fmi3ActivateModelPartition(fmi3Instance instance, fmi3ValueReference clockReference,
                                      fmi3Float64 activationTime)
{
    (void)clockReference;
    (void)activationTime;
    return refuse((instance_t *)instance, "there is no scheduled execution");
}
